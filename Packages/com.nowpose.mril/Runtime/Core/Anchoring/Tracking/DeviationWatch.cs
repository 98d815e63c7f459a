using System;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Median of the recent deviations of a marker from its expected pose. Individual wrong poses therefore have no effect.</summary>
    sealed class DeviationWatch
    {
        const int Capacity = 32, MinPoses = 5, Numbers = 6;

        /// <summary>
        /// Ratios for a normal distribution. SdPerMedian: standard deviation (sd) divided by median absolute deviation. MedianPerMean: sd of a median
        /// divided by sd of a mean.
        /// </summary>
        const double SdPerMedian = 1.4826, MedianPerMean = 1.2533;

        /// <summary>Minimum excess over the limit, in sd of the median. It prevents the state of a marker at the limit from alternating.</summary>
        public const double MinStandardErrors = 3;

        /// <summary>Share of the limit below which a deviation is clearly within it: a hysteresis, for the same purpose.</summary>
        public const double WithinRatio = 0.7;

        /// <summary>
        /// Recent: maximum age of the poses that are used. Oldest: maximum age of the poses that are added if there are too few recent ones, because a
        /// HoloLens 2 may report a code only once in 2 s.
        /// </summary>
        static readonly TimeSpan Recent = TimeSpan.FromMilliseconds(600), Oldest = TimeSpan.FromSeconds(10);

        readonly double[] _values = new double[Capacity * Numbers];
        readonly HeadsetTime[] _times = new HeadsetTime[Capacity];
        readonly double[] _sorted = new double[Capacity];
        int _next, _count;
        double _metresSd;

        /// <summary>Whether there are enough recent poses; otherwise the other values are undefined.</summary>
        public bool IsKnown { get; private set; }

        public double Metres { get; private set; }
        public double Radians => Turn.Radians;

        /// <summary>Rotation from the expected to the measured orientation, in the frame of the poses.</summary>
        public CommonTurn Turn { get; private set; }

        public void Clear()
        {
            _count = 0;
            IsKnown = false;
        }

        /// <param name="expected">Expected pose of the marker.</param>
        /// <param name="seen">Measured pose, in the same frame.</param>
        public void Add(in RigidTransform expected, in RigidTransform seen, HeadsetTime time)
        {
            var apart = expected.Inverse * seen;
            var turn = (seen * expected.Inverse).RotationVector();
            var at = _next * Numbers;
            (_values[at], _values[at + 1], _values[at + 2]) = (apart.X, apart.Y, apart.Z);
            (_values[at + 3], _values[at + 4], _values[at + 5]) = (turn.X, turn.Y, turn.Z);
            _times[_next] = time;
            _next = (_next + 1) % Capacity;
            if (_count < Capacity) _count++;
            Update(time);
        }

        /// <summary>Returns whether the deviation exceeds the limits by more than its own uncertainty.</summary>
        /// <param name="common">Turn that must exceed the limit too. The angles that a device reports drift independently of each other.</param>
        public bool IsBeyond(double metres, double radians, in CommonTurn common) =>
            IsKnown && (Metres > metres + MinStandardErrors * _metresSd || (Turn.IsBeyond(radians) && common.IsBeyond(radians)));

        /// <summary>Returns whether the deviation is clearly within the limits.</summary>
        public bool IsWithin(double metres, double radians, in CommonTurn common) =>
            IsKnown && Metres < WithinRatio * metres && (Turn.IsWithin(radians) || common.IsWithin(radians));

        void Update(HeadsetTime now)
        {
            var count = 0;
            while (count < _count && (now - TimeOf(count) <= Recent || (count < MinPoses && now - TimeOf(count) <= Oldest))) count++;
            IsKnown = count >= MinPoses;
            if (!IsKnown) return;
            var (apart, variance) = Middle(count, 0);
            (Metres, _metresSd) = (apart.Length, Math.Sqrt(variance));
            (apart, variance) = Middle(count, 3);
            Turn = new CommonTurn(apart, variance, 1);
        }

        /// <summary>Returns the medians of three numbers of the newest poses, and the mean variance of these medians.</summary>
        (Vector3D Medians, double Variance) Middle(int count, int first)
        {
            var (x, varianceX) = Median(count, first);
            var (y, varianceY) = Median(count, first + 1);
            var (z, varianceZ) = Median(count, first + 2);
            return (new Vector3D(x, y, z), (varianceX + varianceY + varianceZ) / 3);
        }

        (double Median, double Variance) Median(int count, int number)
        {
            for (var back = 0; back < count; back++) _sorted[back] = _values[(_next - 1 - back + Capacity) % Capacity * Numbers + number];
            var median = PoseMeanSpace.SortToMedian(_sorted, count);
            for (var i = 0; i < count; i++) _sorted[i] = Math.Abs(_sorted[i] - median);
            var sd = MedianPerMean * SdPerMedian * PoseMeanSpace.SortToMedian(_sorted, count);
            return (median, sd * sd / count);
        }

        HeadsetTime TimeOf(int back) => _times[(_next - 1 - back + Capacity) % Capacity];
    }
}
