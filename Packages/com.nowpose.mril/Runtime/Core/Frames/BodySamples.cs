using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;

namespace Nowpose.Frames
{
    /// <summary>
    /// Prepares the samples of one tracked frame: corrects stamps, thins the samples, sorts them, and drops duplicates. All coordinates have the same
    /// times, so this is done once per pose.
    /// </summary>
    /// <remarks>Allocates nothing after construction.</remarks>
    sealed class BodySamples
    {
        // Null if stamps are not corrected and samples are not thinned.
        readonly StampCorrection _stamps;
        double _newestOrder;

        /// <param name="capacity">Number of samples to keep.</param>
        /// <param name="prepares">Whether stamps are corrected and samples less than 5.5 ms apart are left out. The paper's polynomials need neither.</param>
        public BodySamples(int capacity, bool prepares, PredictionLimits limits)
        {
            History = new SampleHistory<BodySample>(capacity);
            Timing = new SampleTiming(limits);
            _stamps = prepares ? new StampCorrection(BodySample.Coordinates) : null;
            Clear();
        }

        /// <summary>The samples for forecasts, with corrected stamps.</summary>
        public SampleHistory<BodySample> History { get; }

        public SampleTiming Timing { get; }

        /// <summary>Whether the history contains no sample yet.</summary>
        public bool IsEmpty => History.Count == 0;

        /// <summary>The newest sample, even if it is left out; <c>default</c> before the first.</summary>
        public BodySample Newest { get; private set; }

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first.</summary>
        public double NewestTime => IsEmpty ? double.NegativeInfinity : Newest.Time;

        /// <summary>Whether the last added sample is newer than all previous samples; otherwise it was overtaken.</summary>
        public bool IsNewest { get; private set; }

        /// <summary>Returns whether a sample is newer than all previous samples.</summary>
        public bool IsNewer(in BodySample sample) => sample.Order > _newestOrder;

        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        /// <returns>Whether the history has changed.</returns>
        public bool Add(in BodySample sample, double displayed)
        {
            var isNewest = IsNewer(sample);
            var time = _stamps == null ? sample.Time : Corrected(sample, isNewest);
            if (isNewest) (_newestOrder, Newest) = (sample.Order, sample);
            var (before, ahead) = (History.NewestTime, time - History.NewestTime);
            if (_stamps != null && isNewest && ahead < SampleBuffer.MinInterval && ahead > 0) return false;
            if (!History.Add(new BodySample(time, sample.Position, sample.Angles, _stamps == null ? sample.Order : time))) return false;
            IsNewest = History.NewestTime > before;
            Timing.Add(History, IsNewest, displayed);
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

        double Corrected(in BodySample sample, bool isNewest)
        {
            Span<double> components = stackalloc double[BodySample.Coordinates];
            for (var c = 0; c < components.Length; c++) components[c] = sample[c];
            return _stamps.Correct(sample.Time, components, isNewest);
        }
    }
}
