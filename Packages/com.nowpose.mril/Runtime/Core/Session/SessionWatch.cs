using System;
using Nowpose.Latency;

namespace Nowpose.Session
{
    /// <summary>Turns what each frame says into the few changes that are worth an event.</summary>
    /// <remarks>
    /// Bad news is told in the frame it comes with, good news once it has lasted half a second. So what flickers is told
    /// once, and news of one kind alternates: no second <see cref="SessionChange.Lost"/> without a
    /// <see cref="SessionChange.Synchronised"/> between. Allocates nothing; one thread.
    /// </remarks>
    sealed class SessionWatch
    {
        static readonly TimeSpan Settle = TimeSpan.FromMilliseconds(500);

        SettledFlag _isSynchronised, _isInRange, _isFresh;
        bool _isDisplayTimeDoubted, _isDisplayTimeImplausible;

        public SessionWatch() => Forget();

        /// <summary>What has changed with a frame.</summary>
        public SessionChange Changed(DisplayFrame frame) =>
            Changed(
                frame.Start, frame.State, frame.IsTimeTrusted, frame.Range, frame.IsDisplayTimeDoubted, frame.IsDisplayTimeImplausible);

        /// <summary>What has changed with a frame, told by its properties.</summary>
        /// <param name="at">Not earlier than the frame before.</param>
        /// <param name="isTimeTrusted">As <see cref="DisplayFrame.IsTimeTrusted"/>.</param>
        /// <param name="isDisplayTimeDoubted">Settled already, as <see cref="DisplayFrame.IsDisplayTimeDoubted"/> is.</param>
        /// <param name="isDisplayTimeImplausible">Settled already, as <see cref="DisplayFrame.IsDisplayTimeImplausible"/> is.</param>
        public SessionChange Changed(
            HeadsetTime at, PoseState pose, bool isTimeTrusted, RangeState range, bool isDisplayTimeDoubted = false,
            bool isDisplayTimeImplausible = false)
        {
            var changes = SessionChange.None;
            if (_isSynchronised.Update(at, isTimeTrusted, Settle)) changes |= isTimeTrusted ? SessionChange.Synchronised : SessionChange.Lost;
            if (range == RangeState.Unknown) _isInRange.Interrupt();
            else if (_isInRange.Update(at, range == RangeState.Inside, Settle))
                changes |= range == RangeState.Inside ? SessionChange.EnteredRange : SessionChange.LeftRange;
            // Before all joints were seen, or while their times mean nothing, nobody can tell how old the pose is.
            if (pose == PoseState.Incomplete || pose == PoseState.Unsynchronised) _isFresh.Interrupt();
            else if (_isFresh.Update(at, pose != PoseState.Held, Settle) && pose == PoseState.Held)
                changes |= SessionChange.Stale;
            if (isDisplayTimeDoubted && !_isDisplayTimeDoubted) changes |= SessionChange.DisplayTimeDoubted;
            _isDisplayTimeDoubted = isDisplayTimeDoubted;
            if (isDisplayTimeImplausible != _isDisplayTimeImplausible)
                changes |= isDisplayTimeImplausible ? SessionChange.DisplayTimeImplausible : SessionChange.DisplayTimePlausible;
            _isDisplayTimeImplausible = isDisplayTimeImplausible;
            return changes;
        }

        /// <summary>The session has ended, to be followed by another or by none: forgets all that was.</summary>
        /// <returns><see cref="SessionChange.Lost"/> if it was synchronised.</returns>
        public SessionChange End()
        {
            var wasSynchronised = _isSynchronised.Value == true;
            Forget();
            return wasSynchronised ? SessionChange.Lost : SessionChange.None;
        }

        void Forget()
        {
            _isSynchronised = new SettledFlag(false);
            _isInRange = new SettledFlag(null);
            _isFresh = new SettledFlag(false);
            _isDisplayTimeDoubted = false;
            _isDisplayTimeImplausible = false;
        }
    }
}
