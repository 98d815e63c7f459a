using System;
using Nowpose.Prediction;

namespace Nowpose.Session.Hindcast
{
    /// <summary>Newest samples of a joint. Each new sample completes the curve between the two samples before it.</summary>
    struct TruthTrack
    {
        TruthSample _first, _second, _third;

        /// <summary>
        /// Start of the interval that is completed next, which is the end of the last complete interval; null before the first sample.
        /// </summary>
        public ControlTime? CompleteUntil => _second.IsKnown ? _second.At : _third.IsKnown ? _third.At : (ControlTime?)null;

        /// <summary>Returns an angle, plus the whole turns that make it nearest to the last sample.</summary>
        public double Unwrapped(double angle) => _third.IsKnown ? angle - JointPredictor.WholeTurns(angle - _third.Position) : angle;

        /// <summary>Adds a sample. A sample that is not newer than the last sample is ignored, because its interval is already complete.</summary>
        /// <param name="maximumGap">Maximum interval between samples. The motion within a longer interval is unknown.</param>
        /// <param name="span">The completed span.</param>
        /// <param name="isKnown">False if the span is too long, so that only its ends are known.</param>
        /// <returns>Whether a span was completed.</returns>
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
