using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>Detects a source whose display times have been implausible for a second.</summary>
    /// <remarks>
    /// Adds the duration of implausible frames to a sum, and subtracts the duration of plausible frames. The state changes when the sum reaches one
    /// second or zero. Individual bad frames are ignored, and a source that is wrong for most of the time is detected. Allocates nothing; not
    /// thread-safe.
    /// </remarks>
    sealed class DisplayTimePlausibility
    {
        /// <summary>Maximum time from the start of a frame to its display, equal to the maximum L_visu of a profile.</summary>
        static readonly TimeSpan MaxAhead = ClockTicks.Span(LatencyProfile.MaxVisuMs / 1000);

        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        /// <summary>Maximum interval between two display times; longer intervals are not counted.</summary>
        static readonly TimeSpan Gap = TimeSpan.FromMilliseconds(250);

        TimeSpan _evidence;
        HeadsetTime? _newest;

        /// <summary>Whether the display times have been implausible for a second and have not been plausible for a second since.</summary>
        public bool IsImplausible { get; private set; }

        /// <summary>Newest display time minus the start of its frame, even if implausible; null before the first display time.</summary>
        public TimeSpan? Ahead { get; private set; }

        /// <summary>Adds the display time of one frame. Do not call it for a frame without a display time.</summary>
        /// <param name="frameStart">Start of the frame, not earlier than the start of the previous frame.</param>
        /// <param name="ahead">Display time minus the frame's start.</param>
        /// <returns>Whether this display time is plausible: 0 to 500 ms after the frame's start.</returns>
        public bool Add(HeadsetTime frameStart, TimeSpan ahead)
        {
            var isPlausible = ahead >= TimeSpan.Zero && ahead <= MaxAhead;
            var passed = frameStart - _newest ?? TimeSpan.Zero;
            _newest = frameStart;
            Ahead = ahead;
            if (passed > Gap) return isPlausible;
            _evidence += isPlausible ? -passed : passed;
            if (_evidence <= TimeSpan.Zero) (_evidence, IsImplausible) = (TimeSpan.Zero, false);
            if (_evidence >= Lasting) (_evidence, IsImplausible) = (Lasting, true);
            return isPlausible;
        }

        /// <summary>Resets the state. Call it when the source changes.</summary>
        public void Reset()
        {
            _evidence = TimeSpan.Zero;
            _newest = null;
            Ahead = null;
            IsImplausible = false;
        }
    }
}
