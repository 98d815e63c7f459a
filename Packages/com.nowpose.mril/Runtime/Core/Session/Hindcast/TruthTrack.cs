using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>The newest samples of a joint. Each new sample completes the curve of the interval before the last.</summary>
    struct TruthTrack
    {
        TruthSample _first, _second, _third;

        /// <summary>End of the intervals that are already complete; null before the first sample.</summary>
        public ControlTime? CompleteUntil => _second.IsKnown ? _second.At : _third.IsKnown ? _third.At : (ControlTime?)null;

        /// <summary>Adds a sample. A sample that is not newer than the last one is ignored, as its interval is already complete.</summary>
        /// <param name="maximumGap">Maximum interval between samples; the motion within a longer one is unknown.</param>
        /// <param name="span">The completed span.</param>
        /// <param name="isKnown">False when only the ends of the span are known.</param>
        /// <returns>False when no span was completed.</returns>
        public bool Add(in TruthSample sample, TimeSpan maximumGap, out TruthSpan span, out bool isKnown)
        {
            span = default;
            isKnown = false;
            if (_third.IsKnown && sample.At <= _third.At) return false;
            var hasSpan = _second.IsKnown;
            if (hasSpan)
            {
                isKnown = _third.At - _second.At <= maximumGap;
                span = new TruthSpan(
                    _first.IsKnown && _second.At - _first.At <= maximumGap ? _first : default, _second, _third,
                    sample.At - _third.At <= maximumGap ? sample : default);
            }
            (_first, _second, _third) = (_second, _third, sample);
            return hasSpan;
        }
    }
}
