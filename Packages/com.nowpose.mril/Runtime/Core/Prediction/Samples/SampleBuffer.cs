using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Keeps the newest samples of a joint or an object, sorted by time; index 0 is the newest. Corrects their stamps, thins them and drops duplicates. All
    /// components have the same times, so this is done once per sample.
    /// </summary>
    sealed class SampleBuffer<TSample> where TSample : struct, ISample<TSample>
    {
        /// <summary>
        /// Minimum interval in s; closer samples are left out, so rates up to 180 Hz are used completely (with stamps in whole
        /// milliseconds, up to 166 Hz). Samples a millisecond apart do not improve forecasts over a tenth of a second, and windows of few samples would contain
        /// mainly their noise.
        /// </summary>
        const double MinInterval = 0.0055;

        readonly TSample[] _samples;
        readonly StampCorrection _stamps;
        readonly bool _thins;
        double _newestOrder;

        /// <param name="capacity">Number of samples to keep.</param>
        /// <param name="stamps">Correction of the stamps of a periodic source; null to use the stamps as they are.</param>
        /// <param name="thins">Whether samples less than 5.5 ms apart are left out.</param>
        public SampleBuffer(int capacity, PredictionLimits limits, StampCorrection stamps = null, bool thins = false)
        {
            (_samples, _stamps, _thins) = (new TSample[capacity], stamps, thins);
            Timing = new SampleTiming(limits);
            Clear();
        }

        /// <summary>Maximum number of samples.</summary>
        public int Capacity => _samples.Length;

        /// <summary>Number of samples.</summary>
        public int Count { get; private set; }

        /// <summary>The sample with this age, with its corrected stamp.</summary>
        public ref readonly TSample this[int age] => ref _samples[age];

        /// <summary>Corrected time of the newest sample, in s; negative infinity before the first.</summary>
        public double NewestTime => Count > 0 ? _samples[0].Time : double.NegativeInfinity;

        /// <summary>Order of the oldest sample in a full buffer, in s; negative infinity while older samples still fit.</summary>
        public double OldestOrder => Count < _samples.Length ? double.NegativeInfinity : _samples[Count - 1].Order;

        public SampleTiming Timing { get; }

        /// <summary>
        /// The newest sample with its stamp as received, even if thinning leaves it out; <c>default</c> before the first. After
        /// <see cref="RemoveNewest"/>, with a corrected stamp.
        /// </summary>
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
        /// <returns>Whether the buffer has changed.</returns>
        public bool Add(in TSample sample, double displayed)
        {
            var isNewestByOrder = HasNewestOrder(sample);
            var time = _stamps == null ? sample.Time : _stamps.Correct(sample, isNewestByOrder);
            // The order decides, because the corrected stamp of the newest sample may precede the corrected stamp of the previous sample.
            if (isNewestByOrder) (_newestOrder, Newest) = (sample.Order, sample);
            var before = NewestTime;
            // The correction may put a newest sample before the previous one. It is then sorted in, not thinned.
            if (_thins && (isNewestByOrder ? time > before && time - before < MinInterval : HasWithin(MinInterval, time))) return false;
            // The samples are sorted by corrected times, so that successive times differ.
            if (!Insert(sample.With(time, _stamps == null ? sample.Order : time))) return false;
            IsNewest = NewestTime > before;
            Timing.Add(this, before, displayed);
            return true;
        }

        /// <summary>Removes the newest sample, because its stamp is wrong, if it is later than a given time in s.</summary>
        /// <returns>Whether there was such a sample.</returns>
        public bool RemoveNewest(double after)
        {
            if (!(NewestTime > after)) return false;
            Array.Copy(_samples, 1, _samples, 0, --Count);
            Newest = _samples[0];
            _newestOrder = Count > 0 ? Newest.Order : double.NegativeInfinity;
            _stamps?.Reset();
            return true;
        }

        /// <summary>Returns the number of newest samples without a gap above the maximum.</summary>
        public int CountWithoutGap(double maximumGap)
        {
            var count = Math.Min(Count, 1);
            while (count < Count && !(_samples[count - 1].Order - _samples[count].Order > maximumGap)) count++;
            return count;
        }

        /// <summary>Returns the earliest time of the newest samples, relative to the newest, in s; not positive.</summary>
        /// <param name="count">Number of newest samples, at most <see cref="Count"/>.</param>
        public double StartOf(int count)
        {
            var start = 0.0;
            for (var age = 1; age < count; age++) start = Math.Min(start, _samples[age].Time - _samples[0].Time);
            return start;
        }

        public void Clear()
        {
            Count = 0;
            Timing.Reset();
            _stamps?.Reset();
            _newestOrder = double.NegativeInfinity;
            Newest = default;
        }

        // Returns false if the buffer is full and the sample is older than its samples, or if another sample has the same order.
        bool Insert(in TSample sample)
        {
            var age = 0;
            while (age < Count && _samples[age].Order > sample.Order) age++;
            if (IsAsOld(age - 1, sample) || IsAsOld(age, sample) || age == _samples.Length) return false;
            Count = Math.Min(Count + 1, _samples.Length);
            Array.Copy(_samples, age, _samples, age + 1, Count - 1 - age);
            _samples[age] = sample;
            return true;
        }

        bool IsAsOld(int age, in TSample sample) => age >= 0 && age < Count && JointSample.IsSameTime(_samples[age].Order, sample.Order);

        bool HasWithin(double interval, double time)
        {
            for (var age = 0; age < Count; age++)
                if (Math.Abs(_samples[age].Time - time) < interval) return true;
            return false;
        }
    }
}
