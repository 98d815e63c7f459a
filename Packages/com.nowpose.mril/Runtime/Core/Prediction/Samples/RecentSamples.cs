using System;

namespace Nowpose.Prediction.Samples
{
    /// <summary>
    /// Keeps the recent samples of a joint or an object, to recognise a repeated sample and a sample that contradicts its neighbours.
    /// </summary>
    sealed class RecentSamples<TSample> where TSample : struct, ISample<TSample>
    {
        /// <summary>
        /// Number of samples kept: a quarter of a second at 1 kHz, the maximum delay of a late sample (<see cref="ArrivalLimits.MaxDelay"/>).
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
        /// Minimum displacement, relative to the noise, at which the positions show the order of the samples. Without it, one of 80 overtaken samples at
        /// rest with noise counts as right, and the sample before it as wrong.
        /// </summary>
        const double MinDisplacementRatio = 2;

        /// <summary>
        /// Number of newest samples whose six second differences estimate the noise: in a longer window, accelerations of an earlier motion would
        /// increase the estimate.
        /// </summary>
        const int NoiseWindow = 8;

        readonly bool _isEndless;
        readonly TSample[] _samples = new TSample[Capacity];
        int _next, _count;

        /// <param name="isEndless">Whether positions are angles in rad that may wrap from π to −π.</param>
        public RecentSamples(bool isEndless) => _isEndless = isEndless;

        public void Add(in TSample sample)
        {
            _samples[_next] = sample;
            _next = (_next + 1) % Capacity;
            if (_count < Capacity) _count++;
        }

        /// <summary>Returns whether a sample with the time of this sample is stored.</summary>
        /// <param name="isRepeated">Whether the stored sample also has the same components.</param>
        public bool Contains(in TSample sample, out bool isRepeated)
        {
            var i = IndexAt(sample.Order);
            isRepeated = i >= 0 && HasSameComponents(_samples[i], sample);
            return i >= 0;
        }

        /// <summary>
        /// Returns whether any component of a sample contradicts the stored sample with the same time or, if there is none, the stored samples
        /// before and after it; false if one of these two is missing.
        /// </summary>
        public bool Contradict(in TSample sample)
        {
            var same = IndexAt(sample.Order);
            var (before, after) = same >= 0 ? (same, same) : (Neighbour(sample.Order, -1), Neighbour(sample.Order, 1));
            if (before < 0 || after < 0) return false;
            var fraction = same >= 0 ? 0 : (sample.Order - Order(before)) / (Order(after) - Order(before));
            for (var c = 0; c < sample.Components; c++)
            {
                var displacement = Difference(Position(after, c), Position(before, c));
                var largest = Math.Max(Math.Abs(displacement), Math.Max(DisplacementFrom(before, -1, c), DisplacementFrom(after, 1, c)));
                if (IsTooFar(sample[c], Position(before, c), displacement * fraction, largest, c)) return true;
            }
            return false;
        }

        /// <summary>
        /// Returns whether the stamp of the newest stored sample is in the future, so that the samples after it seem to be late. The way through all
        /// samples is then shorter in the order of their arrival than in that of their stamps, which gives the shortest way if all stamps are right
        /// and the motion does not reverse twice. If the stamps of the late samples are wrong instead, the velocity changes less without these samples.
        /// </summary>
        /// <param name="late">The samples that seem to be late, all newer than the stored sample before the newest; at least one.</param>
        /// <param name="next">A sample with a later stamp.</param>
        public bool HasWrongNewestStamp(ReadOnlySpan<TSample> late, in TSample next)
        {
            int indexBefore = Neighbour(late[0].Order, -1), indexNewest = Neighbour(next.Order, -1);
            // Two samples with the same stamp may come from a clock with a coarse resolution.
            if (indexBefore < 0 || JointSample.IsSameTime(late[0].Order, Order(indexNewest))) return false;
            var (before, newest, first, last) = (_samples[indexBefore], _samples[indexNewest], late[0], late[late.Length - 1]);
            double byStamp = 0, byArrival = 0, withoutNewest = 0, withoutLate = 0, displacement = 0, noise = 0;
            for (var c = 0; c < next.Components; c++)
            {
                byStamp += Distance(before, first, c) + Distance(last, newest, c) + Distance(newest, next, c);
                byArrival += Distance(before, newest, c) + Distance(newest, first, c) + Distance(last, next, c);
                displacement += Distance(before, next, c);
                noise += Noise(c);
                withoutNewest += Math.Abs(Velocity(last, next, c) - Velocity(before, first, c));
                withoutLate += Math.Abs(Velocity(newest, next, c) - Velocity(before, newest, c));
            }
            // At rest, positions with noise have no order.
            return displacement > MinDisplacementRatio * noise && byStamp > byArrival + noise && withoutNewest < withoutLate;
        }

        public void Clear() => _next = _count = 0;

        public static bool HasSameComponents(in TSample one, in TSample other)
        {
            for (var c = 0; c < one.Components; c++)
                if (one[c] != other[c]) return false;
            return true;
        }

        // Returns whether a sample is too far from the expected position. Before the first motion, no sample is.
        bool IsTooFar(double position, double reference, double displacement, double largest, int component)
        {
            var distance = Math.Abs(Difference(position, reference) - displacement);
            if (!(distance > MaxDistanceRatio * largest + Noise(component))) return false;
            var range = Range(component);
            return distance > MinRangeRatio * range && range > 0;
        }

        // Returns -1 if no sample has this time.
        int IndexAt(double order)
        {
            var i = _count - 1;
            while (i >= 0 && !JointSample.IsSameTime(Order(i), order)) i--;
            return i;
        }

        double Order(int index) => _samples[index].Order;

        double Position(int index, int component) => _samples[index][component];

        double DisplacementFrom(int index, int direction, int component)
        {
            var next = Neighbour(Order(index), direction);
            return next < 0 ? 0 : Math.Abs(Difference(Position(next, component), Position(index, component)));
        }

        // Maximum second difference of the newest samples: large for noise at rest, small in a smooth motion.
        double Noise(int component)
        {
            var noise = 0.0;
            for (var age = 0; age + 2 < Math.Min(_count, NoiseWindow); age++)
                noise = Math.Max(noise, Math.Abs(Step(age, component) - Step(age + 1, component)));
            return noise;
        }

        double Range(int component)
        {
            double minimum = 0, maximum = 0;
            for (var i = 1; i < _count; i++)
            {
                var difference = Difference(Position(i, component), Position(0, component));
                minimum = Math.Min(minimum, difference);
                maximum = Math.Max(maximum, difference);
            }
            return maximum - minimum;
        }

        // Displacement to the sample of this age from the next older one.
        double Step(int age, int component) => Difference(Newest(age, component), Newest(age + 1, component));

        double Newest(int age, int component) => Position((_next - 1 - age + Capacity) % Capacity, component);

        double Distance(in TSample a, in TSample b, int component) => Math.Abs(Difference(b[component], a[component]));

        double Velocity(in TSample a, in TSample b, int component) => Difference(b[component], a[component]) / (b.Order - a.Order);

        double Difference(double a, double b) => _isEndless ? a - b - JointPredictor.WholeTurns(a - b) : a - b;

        // Index of the nearest sample strictly before (direction -1) or after (1); -1 if there is none.
        int Neighbour(double order, int direction)
        {
            var nearest = -1;
            for (var i = 0; i < _count; i++)
            {
                var distance = direction * (Order(i) - order);
                if (distance > 0 && (nearest < 0 || distance < direction * (Order(nearest) - order))) nearest = i;
            }
            return nearest;
        }
    }
}
