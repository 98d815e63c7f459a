using System;
using Nowpose.Messages;

namespace Nowpose.Latency.Load
{
    /// <summary>Decides which steps of a long task fit into a frame, based on the duration of earlier steps of the same kind.</summary>
    /// <remarks>
    /// In each frame, steps run while they fit into the task's share of time. The first step of a frame always runs, so the task progresses even if
    /// a step takes longer than the share, or if its kind has no measured duration yet. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class FrameShare
    {
        /// <summary>
        /// After a step that is shorter than expected, the expected duration decreases by the difference divided by this value, because the next
        /// step may be long again.
        /// </summary>
        const int DecreaseDivisor = 8;

        readonly TimeSpan _share;
        readonly TimeSpan[] _expected;
        HeadsetTime _begin;
        bool _hasWorked;

        /// <param name="milliseconds">Share of each frame, 0.1 to 100 ms.</param>
        /// <param name="kinds">Number of kinds of steps.</param>
        /// <exception cref="InputException">The share is out of range.</exception>
        public FrameShare(double milliseconds, int kinds)
        {
            _share = SettingRange.RequireMs(milliseconds, 0.1, 100, SettingNames.BuildingTime);
            _expected = new TimeSpan[kinds];
            for (var kind = 0; kind < kinds; kind++) _expected[kind] = _share;
        }

        public void BeginFrame(HeadsetTime now)
        {
            _begin = now;
            _hasWorked = false;
        }

        /// <summary>Returns whether a step that starts now fits into this frame.</summary>
        public bool HasRoom(int kind, HeadsetTime now) => !_hasWorked || now - _begin + _expected[kind] <= _share;

        /// <summary>Records the duration of a completed step.</summary>
        public void Took(int kind, TimeSpan length)
        {
            _hasWorked = true;
            var shorter = _expected[kind] - length;
            _expected[kind] = shorter > TimeSpan.Zero ? _expected[kind] - shorter / DecreaseDivisor : length;
        }
    }
}
