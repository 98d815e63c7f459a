using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Prepares the samples of a joint or an object: corrects stamps, thins the samples, sorts them, and drops duplicates. All components have the same
    /// times, so this is done once per sample.
    /// </summary>
    sealed class SampleBuffer<TSample> where TSample : struct, ISample<TSample>
    {
        /// <summary>
        /// Minimum interval in s; closer samples are left out, so rates up to 180 Hz are used completely. Samples a millisecond apart do not improve
        /// forecasts over a tenth of a second, and windows of few samples would contain mainly their noise.
        /// </summary>
        const double MinInterval = 0.0055;

        // Null if stamps are not corrected.
        readonly StampCorrection _stamps;
        readonly bool _thins;
        double _newestOrder;

        /// <param name="capacity">Number of samples to keep.</param>
        /// <param name="parts">Whether stamps of a periodic source are corrected, and whether samples less than 5.5 ms apart are left out.</param>
        public SampleBuffer(int capacity, PredictionParts parts, PredictionLimits limits)
        {
            History = new SampleHistory<TSample>(capacity);
            Timing = new SampleTiming(limits);
            _stamps = (parts & PredictionParts.StampCorrection) != 0 ? new StampCorrection(default(TSample).Components) : null;
            _thins = (parts & PredictionParts.Thinning) != 0;
            Clear();
        }

        /// <summary>The samples for forecasts, with corrected stamps.</summary>
        public SampleHistory<TSample> History { get; }

        public SampleTiming Timing { get; }

        /// <summary>The newest sample, even if it is left out; <c>default</c> before the first.</summary>
        public TSample Newest { get; private set; }

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first.</summary>
        public double NewestStamp => double.IsNegativeInfinity(_newestOrder) ? _newestOrder : Newest.Time;

        /// <summary>
        /// Whether the corrected time of the last added sample is above those of all previous samples. Otherwise it was overtaken, or the correction has
        /// put it before an earlier sample.
        /// </summary>
        public bool IsNewest { get; private set; }

        /// <summary>Returns whether a sample is newer than all previous samples, by its order as received.</summary>
        public bool HasNewestOrder(in TSample sample) => sample.Order > _newestOrder;

        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        /// <returns>Whether the history has changed.</returns>
        public bool Add(in TSample sample, double displayed)
        {
            var isNewestByOrder = HasNewestOrder(sample);
            var time = _stamps == null ? sample.Time : _stamps.Correct(sample, isNewestByOrder);
            // The order decides, because the corrected stamp of the newest sample may precede the corrected stamp of the previous sample.
            if (isNewestByOrder) (_newestOrder, Newest) = (sample.Order, sample);
            var before = History.NewestTime;
            // The correction may put a newest sample before the previous one. It is then sorted in, not thinned.
            if (_thins && (isNewestByOrder ? time > before && time - before < MinInterval : History.HasWithin(MinInterval, time))) return false;
            // The history is sorted by corrected times, so that successive times differ.
            if (!History.Add(sample.With(time, _stamps == null ? sample.Order : time))) return false;
            IsNewest = History.NewestTime > before;
            Timing.Add(History, before, displayed);
            return true;
        }

        public void Clear()
        {
            History.Clear();
            Timing.Reset();
            _stamps?.Reset();
            _newestOrder = double.NegativeInfinity;
            Newest = default;
        }
    }
}
