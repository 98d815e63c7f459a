using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Keeps the newest samples of one joint or one object, sorted by time; index 0 is the newest.</summary>
    sealed class SampleHistory<TSample> where TSample : struct, ISample<TSample>
    {
        readonly TSample[] _samples;

        public SampleHistory(int capacity) => _samples = new TSample[capacity];

        public int Count { get; private set; }

        public ref readonly TSample this[int age] => ref _samples[age];

        public double NewestTime => Count > 0 ? _samples[0].Time : double.NegativeInfinity;

        /// <summary>Order of the oldest sample in a full history, in s; negative infinity while older samples still fit.</summary>
        public double OldestOrder => Count < _samples.Length ? double.NegativeInfinity : _samples[Count - 1].Order;

        /// <returns>False if the history is full and the sample is older than its samples, or if another sample has the same order.</returns>
        public bool Add(in TSample sample)
        {
            var age = 0;
            while (age < Count && _samples[age].Order > sample.Order) age++;
            if (IsAsOld(age - 1, sample) || IsAsOld(age, sample) || age == _samples.Length) return false;
            Count = Math.Min(Count + 1, _samples.Length);
            Array.Copy(_samples, age, _samples, age + 1, Count - 1 - age);
            _samples[age] = sample;
            return true;
        }

        /// <summary>Returns whether a sample is less than an interval before or after a time, both in s.</summary>
        public bool HasWithin(double interval, double time)
        {
            for (var age = 0; age < Count; age++)
                if (Math.Abs(_samples[age].Time - time) < interval) return true;
            return false;
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

        public void Clear() => Count = 0;

        bool IsAsOld(int age, in TSample sample) =>
            age >= 0 && age < Count && JointSample.IsSameTime(_samples[age].Order, sample.Order);
    }
}
