using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>Keeps the newest samples of one joint, sorted by time; index 0 is the newest.</summary>
    sealed class SampleHistory
    {
        readonly JointSample[] _newestFirst;

        public SampleHistory(int capacity) => _newestFirst = new JointSample[capacity];

        public int Count { get; private set; }

        public ref readonly JointSample this[int age] => ref _newestFirst[age];

        public double NewestTime => Count > 0 ? _newestFirst[0].Time : double.NegativeInfinity;

        public double NewestPosition => Count > 0 ? _newestFirst[0].Position : 0;

        /// <summary>Order of the oldest sample in a full history, in s; negative infinity while older samples still fit.</summary>
        public double Oldest => Count < _newestFirst.Length ? double.NegativeInfinity : _newestFirst[Count - 1].Order;

        /// <returns>False if the history is full and the sample is older than its samples, or if another sample has the same time.</returns>
        public bool Add(in JointSample sample)
        {
            var age = 0;
            while (age < Count && _newestFirst[age].Order > sample.Order) age++;
            if (IsAsOld(age - 1, sample) || IsAsOld(age, sample) || age == _newestFirst.Length) return false;
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

        /// <summary>Returns whether no sample precedes the sample of this age, or only with more than the maximum gap.</summary>
        public bool HasGap(int age, double maximumGap) =>
            age + 1 >= Count || _newestFirst[age].Order - _newestFirst[age + 1].Order > maximumGap;

        public void Clear() => Count = 0;

        bool IsAsOld(int age, in JointSample sample) =>
            age >= 0 && age < Count && JointSample.IsSameTime(_newestFirst[age].Order, sample.Order);

        void Insert(int age, in JointSample sample)
        {
            if (Count < _newestFirst.Length) Count++;
            for (var i = Count - 1; i > age; i--) _newestFirst[i] = _newestFirst[i - 1];
            _newestFirst[age] = sample;
        }
    }
}
