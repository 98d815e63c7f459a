using System;

namespace Nowpose.Latency.Load
{
    /// <summary>Which steps of a long work a frame has room for, by how long steps of their kind took before.</summary>
    /// <remarks>
    /// A frame's steps end within its share of time. One that takes longer by itself, or whose kind is not known yet, has a frame for
    /// itself, so that work always goes on. Allocates nothing; not thread-safe.
    /// </remarks>
    sealed class FrameShare
    {
        /// <summary>By so much of the difference a shorter step is believed: the next one may be as long as the longest again.</summary>
        const int Patience = 8;

        readonly TimeSpan _share;
        readonly TimeSpan[] _expected;
        HeadsetTime _begin;
        bool _hasWorked;

        /// <param name="milliseconds">Of each frame, 0.1 to 100 ms.</param>
        /// <param name="kinds">How many kinds of steps there are.</param>
        /// <exception cref="InputException">Out of range.</exception>
        public FrameShare(double milliseconds, int kinds)
        {
            _share = SettingRange.RequireMs(milliseconds, 0.1, 100, "time for building per frame");
            _expected = new TimeSpan[kinds];
            for (var kind = 0; kind < kinds; kind++) _expected[kind] = _share;
        }

        public void BeginFrame(HeadsetTime now)
        {
            _begin = now;
            _hasWorked = false;
        }

        /// <summary>Whether a step that begins now may be done in this frame.</summary>
        public bool HasRoom(int kind, HeadsetTime now) => !_hasWorked || now - _begin + _expected[kind] <= _share;

        /// <summary>A step was done.</summary>
        public void Took(int kind, TimeSpan length)
        {
            _hasWorked = true;
            var shorter = _expected[kind] - length;
            _expected[kind] = shorter > TimeSpan.Zero ? _expected[kind] - shorter / Patience : length;
        }
    }
}
