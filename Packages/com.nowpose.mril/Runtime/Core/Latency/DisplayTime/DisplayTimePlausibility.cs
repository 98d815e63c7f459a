using System;

namespace Nowpose.Latency.DisplayTime
{
    /// <summary>Finds a source that answers with display times that cannot be those of the frame, for a second.</summary>
    /// <remarks>
    /// Implausible frames count up, plausible ones down; the state changes at one second and at zero. So single bad frames are ignored, and
    /// a source that is wrong more often than right is found. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class DisplayTimePlausibility
    {
        /// <summary>The display shows a frame at most this long after it began; longer than any L_visu that a profile may hold.</summary>
        static readonly TimeSpan Furthest = ClockTicks.Span(LatencyProfile.GreatestVisuMs / 1000);

        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        /// <summary>A longer pause between two answers counts for neither side.</summary>
        static readonly TimeSpan Gap = TimeSpan.FromMilliseconds(250);

        TimeSpan _evidence;
        HeadsetTime? _newest;

        /// <summary>Whether the answers have been implausible for a second, and not yet plausible for another.</summary>
        public bool IsImplausible { get; private set; }

        /// <summary>Newest answer minus its frame's start, plausible or not; null before the first.</summary>
        public TimeSpan? Ahead { get; private set; }

        /// <summary>Takes the answer for one frame. A frame without an answer is not added.</summary>
        /// <param name="frameStart">Not earlier than the one before.</param>
        /// <param name="ahead">Display time minus the frame's start.</param>
        /// <returns>Whether this answer is plausible: 0 to 500 ms.</returns>
        public bool Add(HeadsetTime frameStart, TimeSpan ahead)
        {
            var isPlausible = ahead >= TimeSpan.Zero && ahead <= Furthest;
            var passed = frameStart - _newest ?? TimeSpan.Zero;
            _newest = frameStart;
            Ahead = ahead;
            if (passed > Gap) return isPlausible;
            _evidence += isPlausible ? -passed : passed;
            if (_evidence <= TimeSpan.Zero) (_evidence, IsImplausible) = (TimeSpan.Zero, false);
            if (_evidence >= Lasting) (_evidence, IsImplausible) = (Lasting, true);
            return isPlausible;
        }

        /// <summary>Forgets all: another source.</summary>
        public void Reset()
        {
            _evidence = TimeSpan.Zero;
            _newest = null;
            Ahead = null;
            IsImplausible = false;
        }
    }
}
