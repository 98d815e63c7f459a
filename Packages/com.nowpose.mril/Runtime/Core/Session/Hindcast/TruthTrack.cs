using System;

namespace Nowpose.Session.Hindcast
{
    /// <summary>The newest four samples of a joint: each new one completes what is known of the interval before the last.</summary>
    struct TruthTrack
    {
        TruthSample _first, _second, _third;

        /// <summary>Up to where the way of the joint is told; null while nothing is.</summary>
        public ControlTime? ToldUntil => _second.IsKnown ? _second.At : _third.IsKnown ? _third.At : (ControlTime?)null;

        /// <summary>Takes a sample; one that was overtaken comes too late, its interval is told already.</summary>
        /// <param name="maximumGap">Between samples that lie further apart nobody knows how the joint moved.</param>
        /// <param name="span">What is known now.</param>
        /// <param name="isKnown">False when nothing is known of the span but its ends.</param>
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
