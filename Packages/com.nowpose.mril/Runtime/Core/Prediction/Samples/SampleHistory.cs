using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Keeps the newest samples of one joint or one object, sorted by time; index 0 is the newest.</summary>
    sealed class SampleHistory<TSample> where TSample : struct, ISample<TSample>
    {
        readonly int _capacity;

        // Ring buffer: the sample with a given age is at (_newest + age) & _mask.
        readonly TSample[] _ring;
        readonly int _mask;
        int _newest;

        public SampleHistory(int capacity)
        {
            _capacity = capacity;
            var length = 1;
            while (length < capacity) length *= 2;
            (_ring, _mask) = (new TSample[length], length - 1);
        }

        public int Count { get; private set; }

        public ref readonly TSample this[int age]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => ref At(age);
        }

        public double NewestTime => Count > 0 ? At(0).Time : double.NegativeInfinity;

        /// <summary>Order of the oldest sample in a full history, in s; negative infinity while older samples still fit.</summary>
        public double Oldest => Count < _capacity ? double.NegativeInfinity : At(Count - 1).Order;

        /// <returns>False if the history is full and the sample is older than its samples, or if another sample has the same time.</returns>
        public bool Add(in TSample sample)
        {
            var age = 0;
            while (age < Count && At(age).Order > sample.Order) age++;
            if (IsAsOld(age - 1, sample) || IsAsOld(age, sample) || age == _capacity) return false;
            Insert(age, sample);
            return true;
        }

        /// <summary>Returns the number of newest samples without a gap above the maximum.</summary>
        public int CountWithoutGap(double maximumGap)
        {
            var count = Math.Min(Count, 1);
            while (count < Count && !HasGap(count - 1, maximumGap)) count++;
            return count;
        }

        /// <summary>Returns the earliest time of the newest samples, relative to the newest, in s; not positive.</summary>
        /// <param name="count">Number of newest samples, at most <see cref="Count"/>.</param>
        public double StartOf(int count)
        {
            var start = 0.0;
            for (var age = 1; age < count; age++) start = Math.Min(start, At(age).Time - At(0).Time);
            return start;
        }

        /// <summary>Returns whether the sample of this age has no predecessor, or follows its predecessor after more than the maximum gap.</summary>
        public bool HasGap(int age, double maximumGap) =>
            age + 1 >= Count || At(age).Order - At(age + 1).Order > maximumGap;

        public void Clear() => Count = 0;

        bool IsAsOld(int age, in TSample sample) =>
            age >= 0 && age < Count && JointSample.IsSameTime(At(age).Order, sample.Order);

        void Insert(int age, in TSample sample)
        {
            if (Count < _capacity) Count++;
            _newest = (_newest - 1) & _mask;
            for (var i = 0; i < age; i++) At(i) = At(i + 1);
            At(age) = sample;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        ref TSample At(int age) => ref _ring[(_newest + age) & _mask];
    }
}
