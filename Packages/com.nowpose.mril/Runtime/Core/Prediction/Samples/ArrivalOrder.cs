using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Distinguishes samples that were overtaken on the network from those of a clock that went back.
    /// </summary>
    /// <remarks>
    /// In both cases the stamp is not newer than the newest. If a sample of a stepped clock is taken for an overtaken one, the section
    /// is wrong; if an overtaken one is taken for a stepped clock, all learned state is lost. Therefore late samples wait.
    /// When a newer sample arrives, they were overtaken and are inserted. When their number, or positions that contradict the other
    /// samples, show that time went back, the history restarts with them. Allocates nothing after construction.
    /// </remarks>
    sealed class ArrivalOrder
    {
        readonly RecentSamples _recent;
        readonly LateSamples _late = new LateSamples();
        readonly JointSample[] _ready = new JointSample[LateSamples.Capacity + 1];
        double _newest = double.NegativeInfinity;
        int _count;

        /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
        public ArrivalOrder(bool isEndless) => _recent = new RecentSamples(isEndless);

        /// <summary>
        /// Samples to use now, in order: those that waited and are now classified, and the one added if it is the newest.
        /// </summary>
        public ReadOnlySpan<JointSample> Ready => _ready.AsSpan(0, _count);

        /// <summary>Number of times that the samples showed that time went back; all earlier samples are void then.</summary>
        public int Restarts { get; private set; }

        /// <param name="oldest">
        /// Order below which samples are too old for the prediction, in s; they are still evidence of a clock that went back.
        /// </param>
        public DropReason Add(in JointSample sample, double oldest)
        {
            _count = 0;
            if (RecentSamples.IsSameTime(_newest, sample)) return DropReason.DuplicateSample;
            if (sample.Order > _newest)
            {
                ReleaseLate(alsoDropped: false);
                Release(sample);
                return DropReason.None;
            }
            if (_recent.Contains(sample) || _late.Contains(sample)) return DropReason.DuplicateSample;
            var reason = sample.Order < oldest ? DropReason.LateSample
                : _recent.ContainsTimeOf(sample) ? DropReason.DuplicateSample : DropReason.None;
            if (!_late.IsContinuedBy(sample)) ReleaseLate(alsoDropped: false);
            _late.Add(sample, reason != DropReason.None, _recent.Contradict(sample));
            if (!_late.HasTimeGoneBack(_newest)) return reason;
            Restarts++;
            _recent.Clear();
            _newest = double.NegativeInfinity;
            ReleaseLate(alsoDropped: true);
            return DropReason.None;
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
