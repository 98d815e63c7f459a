using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Keeps the recent samples of a joint, to recognise a repeated sample and a sample that contradicts its neighbours. Allocates nothing
    /// after construction.
    /// </summary>
    sealed class RecentSamples
    {
        /// <summary>
        /// Number of samples kept: a quarter of a second at 1 kHz, the maximum delay of a late sample (<see cref="ArrivalOrder.MaxDelay"/>).
        /// </summary>
        const int Capacity = 256;

        /// <summary>
        /// Maximum distance from the line between the neighbours, or from the sample with the same time, relative to the displacement there. The
        /// distance of a sample that was overtaken on the network is smaller, even at a reversal. After a step of the clock back by two intervals,
        /// the distance is twice the displacement.
        /// </summary>
        const double MaxDistanceRatio = 1.5;

        /// <summary>Minimum significant difference relative to the range of the recent samples; it exceeds an encoder count, for example.</summary>
        const double MinRangeRatio = 1e-3;

        /// <summary>
        /// Number of newest samples whose six second differences estimate the noise: in a longer window, accelerations of an earlier motion would
        /// increase the estimate.
        /// </summary>
        const int NoiseWindow = 8;

        readonly bool _isEndless;
        readonly (double Order, double Position)[] _samples = new (double, double)[Capacity];
        int _next;
        int _count;

        /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
        public RecentSamples(bool isEndless) => _isEndless = isEndless;

        public void Add(in JointSample sample)
        {
            _samples[_next] = (sample.Order, sample.Position);
            _next = (_next + 1) % Capacity;
            if (_count < Capacity) _count++;
        }

        /// <summary>Finds the position of the stored sample with the given time.</summary>
        public bool TryFind(double order, out double position)
        {
            var i = IndexAt(order);
            position = i >= 0 ? _samples[i].Position : double.NaN;
            return i >= 0;
        }

        /// <summary>
        /// Returns whether the position of a sample contradicts the stored sample with the same time or, if there is none, the stored samples
        /// before and after it; false if one of these two is missing.
        /// </summary>
        public bool Contradict(in JointSample sample)
        {
            var same = IndexAt(sample.Order);
            if (same >= 0)
                return IsElsewhere(sample.Position, _samples[same].Position, 0, Math.Max(DisplacementFrom(same, -1), DisplacementFrom(same, 1)));
            var before = Neighbour(sample.Order, -1);
            var after = Neighbour(sample.Order, 1);
            if (before < 0 || after < 0) return false;
            var displacement = Difference(_samples[after].Position, _samples[before].Position);
            var onLine = displacement * (sample.Order - _samples[before].Order) / (_samples[after].Order - _samples[before].Order);
            var largest = Math.Max(Math.Abs(displacement), Math.Max(DisplacementFrom(before, -1), DisplacementFrom(after, 1)));
            return IsElsewhere(sample.Position, _samples[before].Position, onLine, largest);
        }

        public void Clear() => _next = _count = 0;

        // Returns whether a sample is too far from the expected position. Before the first motion, no sample is.
        bool IsElsewhere(double position, double reference, double displacement, double largest)
        {
            var distance = Math.Abs(Difference(position, reference) - displacement);
            if (!(distance > MaxDistanceRatio * largest + Noise)) return false;
            var range = Range;
            return distance > MinRangeRatio * range && range > 0;
        }

        // Returns -1 if no sample has this time.
        int IndexAt(double order)
        {
            var i = _count - 1;
            while (i >= 0 && !JointSample.IsSameTime(_samples[i].Order, order)) i--;
            return i;
        }

        double DisplacementFrom(int index, int direction)
        {
            var next = Neighbour(_samples[index].Order, direction);
            return next < 0 ? 0 : Math.Abs(Difference(_samples[next].Position, _samples[index].Position));
        }

        // Maximum second difference of the newest samples: large for noise at rest, small in a smooth motion.
        double Noise
        {
            get
            {
                var noise = 0.0;
                for (var age = 0; age + 2 < Math.Min(_count, NoiseWindow); age++)
                    noise = Math.Max(noise, Math.Abs(Difference(Newest(age), Newest(age + 1)) - Difference(Newest(age + 1), Newest(age + 2))));
                return noise;
            }
        }

        double Range
        {
            get
            {
                double minimum = 0, maximum = 0;
                for (var i = 1; i < _count; i++)
                {
                    var difference = Difference(_samples[i].Position, _samples[0].Position);
                    minimum = Math.Min(minimum, difference);
                    maximum = Math.Max(maximum, difference);
                }
                return maximum - minimum;
            }
        }

        double Newest(int age) => _samples[(_next - 1 - age + Capacity) % Capacity].Position;

        double Difference(double a, double b) => _isEndless ? a - b - SampleBuffer.WholeTurns(a - b) : a - b;

        // Index of the nearest sample strictly before (direction -1) or after (1); -1 if there is none.
        int Neighbour(double order, int direction)
        {
            var nearest = -1;
            for (var i = 0; i < _count; i++)
            {
                var distance = direction * (_samples[i].Order - order);
                if (distance > 0 && (nearest < 0 || distance < direction * (_samples[nearest].Order - order))) nearest = i;
            }
            return nearest;
        }
    }
}
