using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Judges samples as they arrive: tells those that were overtaken on the network from those of a clock that went back.
    /// </summary>
    /// <remarks>
    /// Both have stamps that are not newer than the newest. Taking a sample of a stepped clock for an overtaken one tears
    /// the section apart, and taking an overtaken one for a stepped clock throws away all that was learned. So late samples wait:
    /// when a newer one comes they were overtaken and go to their places; when they tell by their number, or by positions
    /// where the joint was not, that time went back, the history restarts with them. Allocates nothing once made.
    /// </remarks>
    sealed class ArrivalOrder
    {
        readonly RecentSamples _recent;
        readonly LateSamples _late = new LateSamples();
        readonly JointSample[] _ready = new JointSample[LateSamples.Capacity + 1];
        double _newest = double.NegativeInfinity;
        int _count;

        /// <param name="isEndless">Whether positions are angles in rad that may come back from π to −π.</param>
        public ArrivalOrder(bool isEndless) => _recent = new RecentSamples(isEndless);

        /// <summary>
        /// Samples to take now, in order: those that waited, once it is clear what they are, and the one added, if it is the newest.
        /// </summary>
        public ReadOnlySpan<JointSample> Ready => _ready.AsSpan(0, _count);

        /// <param name="oldest">
        /// Samples older than this are of no use for a prediction, s; they still tell of a clock that went back.
        /// </param>
        public SampleOutcome Add(in JointSample sample, double oldest)
        {
            _count = 0;
            if (RecentSamples.IsSameTime(_newest, sample)) return SampleOutcome.Duplicate;
            if (sample.Order > _newest)
            {
                ReleaseLate(alsoDropped: false);
                Release(sample);
                return SampleOutcome.Accepted;
            }
            if (_recent.Contains(sample) || _late.Contains(sample)) return SampleOutcome.Duplicate;
            var outcome = sample.Order < oldest ? SampleOutcome.TooOld
                : _recent.ContainsTimeOf(sample) ? SampleOutcome.Duplicate : SampleOutcome.Late;
            if (!_late.IsContinuedBy(sample)) ReleaseLate(alsoDropped: false);
            _late.Add(sample, outcome != SampleOutcome.Late, _recent.Contradict(sample));
            if (!_late.TellThatTimeWentBack(_newest)) return outcome;
            _recent.Clear();
            _newest = double.NegativeInfinity;
            ReleaseLate(alsoDropped: true);
            return SampleOutcome.StartedAnew;
        }

        public void Clear()
        {
            _recent.Clear();
            _late.Clear();
            _newest = double.NegativeInfinity;
            _count = 0;
        }

        void ReleaseLate(bool alsoDropped)
        {
            for (var i = 0; i < _late.All.Length; i++)
                if (alsoDropped || !_late.IsDropped(i)) Release(_late.All[i]);
            _late.Clear();
        }

        void Release(in JointSample sample)
        {
            _newest = Math.Max(_newest, sample.Order);
            _recent.Add(sample);
            _ready[_count++] = sample;
        }
    }
}
