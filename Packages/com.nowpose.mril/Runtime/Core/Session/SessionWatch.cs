using System;
using Nowpose.Latency;

namespace Nowpose.Session
{
    /// <summary>Detects changes of the session's state from one frame to the next, which are reported as events.</summary>
    /// <remarks>
    /// A deterioration is reported in the frame in which it occurs; an improvement is reported after it has lasted half a second. A flickering state
    /// is therefore reported once, and the two changes alternate: <see cref="SessionChange.Lost"/> is not reported twice without a
    /// <see cref="SessionChange.Synchronised"/> in between. Allocates nothing; single-threaded.
    /// </remarks>
    sealed class SessionWatch
    {
        /// <summary>Time for which an improvement must last before it is reported or shown.</summary>
        public static readonly TimeSpan Settle = TimeSpan.FromMilliseconds(500);

        SettledFlag _isSynchronised, _isInRange, _isFresh;
        bool _hasMissedRefreshes, _isDisplayTimeInconsistent, _isDisplayTimeImplausible;

        public SessionWatch() => Reset();

        /// <summary>Returns the changes from the previous frame to this frame.</summary>
        public SessionChange Changed(DisplayFrame frame) =>
            Changed(
                frame.Start, frame.State, frame.IsTimeTrusted, frame.Range, frame.MissesRefreshes, frame.IsDisplayTimeInconsistent,
                frame.IsDisplayTimeImplausible);

        /// <summary>Returns the changes from the previous frame to a frame with these values.</summary>
        /// <param name="at">Start of the frame, not earlier than the start of the previous frame.</param>
        /// <param name="isTimeTrusted">Value of <see cref="DisplayFrame.IsTimeTrusted"/>.</param>
        /// <param name="missesRefreshes">Value of <see cref="DisplayFrame.MissesRefreshes"/>.</param>
        /// <param name="isDisplayTimeInconsistent">Value of <see cref="DisplayFrame.IsDisplayTimeInconsistent"/>, which has hysteresis.</param>
        /// <param name="isDisplayTimeImplausible">Value of <see cref="DisplayFrame.IsDisplayTimeImplausible"/>, which has hysteresis.</param>
        public SessionChange Changed(
            HeadsetTime at, PoseState pose, bool isTimeTrusted, RangeState range, bool missesRefreshes = false,
            bool isDisplayTimeInconsistent = false, bool isDisplayTimeImplausible = false)
        {
            var changes = SessionChange.None;
            if (_isSynchronised.Update(at, isTimeTrusted, Settle)) changes |= isTimeTrusted ? SessionChange.Synchronised : SessionChange.Lost;
            if (range == RangeState.Outside) _hasMissedRefreshes = missesRefreshes;
            // If only missed refreshes were outside, their end is the return, although the range may be unknown.
            if (range == RangeState.Unknown && !_hasMissedRefreshes) _isInRange.Interrupt();
            else if (_isInRange.Update(at, range != RangeState.Outside, Settle))
                changes |= range != RangeState.Outside ? SessionChange.EnteredRange : SessionChange.LeftRange;
            // The age of the pose is unknown before all joints have samples and while the clock is not synchronised.
            if (pose == PoseState.Incomplete || pose == PoseState.Unsynchronised) _isFresh.Interrupt();
            else if (_isFresh.Update(at, pose != PoseState.Held, Settle) && pose == PoseState.Held)
                changes |= SessionChange.Stale;
            if (isDisplayTimeInconsistent && !_isDisplayTimeInconsistent) changes |= SessionChange.DisplayTimeInconsistent;
            _isDisplayTimeInconsistent = isDisplayTimeInconsistent;
            if (isDisplayTimeImplausible != _isDisplayTimeImplausible)
                changes |= isDisplayTimeImplausible ? SessionChange.DisplayTimeImplausible : SessionChange.DisplayTimePlausible;
            _isDisplayTimeImplausible = isDisplayTimeImplausible;
            return changes;
        }

        /// <summary>Resets the state when the session ends.</summary>
        /// <returns><see cref="SessionChange.Lost"/> if the session was synchronised.</returns>
        public SessionChange End()
        {
            var wasSynchronised = _isSynchronised.Value == true;
            Reset();
            return wasSynchronised ? SessionChange.Lost : SessionChange.None;
        }

        void Reset()
        {
            _isSynchronised = new SettledFlag(false);
            _isInRange = new SettledFlag(null);
            _isFresh = new SettledFlag(false);
            _hasMissedRefreshes = false;
            _isDisplayTimeInconsistent = false;
            _isDisplayTimeImplausible = false;
        }
    }
}
