using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Prepares one joint's samples: unwraps angles, corrects stamps, thins the samples, sorts them, and drops duplicates.
    /// </summary>
    /// <remarks>Allocates nothing after construction.</remarks>
    sealed class SampleBuffer
    {
        /// <summary>One turn, in rad.</summary>
        const double Turn = 2 * Math.PI;

        /// <summary>
        /// Minimum interval in s; closer samples are left out unless they were overtaken, so rates up to 180 Hz are used completely. Samples a
        /// millisecond apart do not improve forecasts over a tenth of a second, and windows of few samples would contain mainly their noise.
        /// </summary>
        public const double MinInterval = 0.0055;

        readonly bool _isEndless;
        readonly bool _thins;
        readonly StampCorrection _stamps;
        double _newestOrder;
        double _unwrapped;

        /// <param name="capacity">Number of samples to keep.</param>
        /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
        /// <param name="corrects">Whether stamps of a periodic source are corrected.</param>
        /// <param name="thins">Whether samples less than 5.5 ms apart are left out.</param>
        public SampleBuffer(int capacity, bool isEndless, bool corrects, bool thins)
        {
            History = new SampleHistory<JointSample>(capacity);
            _isEndless = isEndless;
            _thins = thins;
            _stamps = corrects ? new StampCorrection(components: 1) : null;
            Clear();
        }

        /// <summary>The samples for forecasts.</summary>
        public SampleHistory<JointSample> History { get; }

        /// <summary>
        /// Position of the newest sample, which a display without prediction shows even if the sample is left out; 0 before the first sample.
        /// </summary>
        public double NewestPosition { get; private set; }

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first.</summary>
        public double NewestStamp { get; private set; }

        /// <summary>Whole turns that unwrapping added to the newest position, in rad.</summary>
        public double Shift { get; private set; }

        /// <summary>Returns whether a sample is newer than all previous samples.</summary>
        public bool IsNewer(in JointSample sample) => sample.Order > _newestOrder;

        /// <returns>Whether the history has changed.</returns>
        public bool Add(in JointSample sample)
        {
            var isNewest = IsNewer(sample);
            var position = Unwrapped(sample);
            Span<double> component = stackalloc[] { position };
            var time = _stamps == null ? sample.Time : _stamps.Correct(sample.Time, component, isNewest);
            // The order decides, because the corrected stamp of the newest sample may precede the corrected stamp of the previous sample.
            if (isNewest)
            {
                (_newestOrder, _unwrapped) = (sample.Order, position);
                (NewestStamp, NewestPosition, Shift) = (sample.Time, sample.Position, position - sample.Position);
            }
            if (_thins && isNewest && time - History.NewestTime < MinInterval && time > History.NewestTime) return false;
            var order = _stamps == null ? sample.Order : time;
            return History.Add(new JointSample(time, position, order, sample.Velocity, sample.Acceleration));
        }

        public void Clear()
        {
            History.Clear();
            _stamps?.Reset();
            _newestOrder = NewestStamp = double.NegativeInfinity;
            NewestPosition = _unwrapped = Shift = 0;
        }

        /// <summary>Returns the whole turns nearest to an angle, in rad.</summary>
        public static double WholeTurns(double angle) => Turn * Math.Round(angle / Turn);

        // Assumes the shorter way round between two samples more than half a turn apart.
        double Unwrapped(in JointSample sample)
        {
            if (!_isEndless || double.IsNegativeInfinity(_newestOrder)) return sample.Position;
            return sample.Position + WholeTurns(_unwrapped - sample.Position);
        }
    }
}
