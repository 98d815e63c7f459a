using System;

namespace Nowpose.Session
{
    /// <summary>Fraction of the frames of the last ten seconds that had a current pose. Allocates nothing after construction.</summary>
    /// <remarks>Counts whole seconds of the headset clock, so the window covers nine to ten seconds.</remarks>
    sealed class CurrentShare
    {
        const int Seconds = 10;

        readonly long[] _secondOf = new long[Seconds];
        readonly int[] _frames = new int[Seconds];
        readonly int[] _current = new int[Seconds];
        long _newest = long.MinValue;

        /// <summary>Fraction from 0 to 1; null before the first frame.</summary>
        public double? Value
        {
            get
            {
                int frames = 0, current = 0;
                for (var i = 0; i < Seconds; i++)
                {
                    if (_frames[i] == 0 || _newest - _secondOf[i] >= Seconds) continue;
                    frames += _frames[i];
                    current += _current[i];
                }
                return frames == 0 ? (double?)null : (double)current / frames;
            }
        }

        public void Add(HeadsetTime at, bool isCurrent)
        {
            _newest = (long)Math.Floor(ClockTicks.Seconds(at.SinceEpoch));
            var place = (int)((_newest % Seconds + Seconds) % Seconds);
            if (_secondOf[place] != _newest) _frames[place] = _current[place] = 0;
            _secondOf[place] = _newest;
            _frames[place]++;
            if (isCurrent) _current[place]++;
        }
    }
}
