using System;

namespace Nowpose.Prediction
{
    /// <summary>The newest samples of one joint, sorted whatever order they came in; index 0 is the newest.</summary>
    sealed class SampleHistory
    {
        /// <summary>Nearer than this two samples are the same one sent twice: no machine samples a joint a million times a second.</summary>
        const double DuplicateSeconds = 1e-6;

        readonly JointSample[] _newestFirst;

        public SampleHistory(int capacity) => _newestFirst = new JointSample[capacity];

        public int Count { get; private set; }

        public ref readonly JointSample this[int age] => ref _newestFirst[age];

        public double NewestTime => Count > 0 ? _newestFirst[0].Time : double.NegativeInfinity;

        public double NewestPosition => Count > 0 ? _newestFirst[0].Position : 0;

        public SampleOutcome Add(in JointSample sample)
        {
            var age = 0;
            while (age < Count && _newestFirst[age].Order > sample.Order) age++;
            if (IsDuplicate(age - 1, sample) || IsDuplicate(age, sample)) return SampleOutcome.Duplicate;
            if (age == _newestFirst.Length) return SampleOutcome.TooOld;
            Insert(age, sample);
            return age == 0 ? SampleOutcome.Accepted : SampleOutcome.Late;
        }

        /// <summary>How many samples, from the newest back, follow each other without a longer gap than allowed.</summary>
        public int CountWithoutGap(double maximumGap)
        {
            var count = Math.Min(Count, 1);
            while (count < Count && _newestFirst[count - 1].Order - _newestFirst[count].Order <= maximumGap) count++;
            return count;
        }

        public void Clear() => Count = 0;

        bool IsDuplicate(int age, in JointSample sample) =>
            age >= 0 && age < Count && Math.Abs(_newestFirst[age].Order - sample.Order) < DuplicateSeconds;

        void Insert(int age, in JointSample sample)
        {
            if (Count < _newestFirst.Length) Count++;
            for (var i = Count - 1; i > age; i--) _newestFirst[i] = _newestFirst[i - 1];
            _newestFirst[age] = sample;
        }
    }
}
