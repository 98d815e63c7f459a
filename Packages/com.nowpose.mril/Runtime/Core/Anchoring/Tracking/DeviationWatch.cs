using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>How far a marker is lately from where it belongs: a median, which single wrong poses do not move.</summary>
    sealed class DeviationWatch
    {
        const int Capacity = 32, Least = 5, Numbers = 6;

        /// <summary>Of a normal distribution, the sd in medians of the distance from the median, and that of a median in sd of a mean.</summary>
        const double SdPerMedian = 1.4826, MedianPerMean = 1.2533;

        /// <summary>Sd of the median beyond the limit: a marker at the limit does not come and go.</summary>
        const double Sure = 3;

        /// <summary>What a camera sees in it is enough; where it sees less often, the newest few have to do, unless they are too old.</summary>
        static readonly TimeSpan Recent = TimeSpan.FromMilliseconds(600), Oldest = TimeSpan.FromSeconds(5);

        readonly double[] _values = new double[Capacity * Numbers];
        readonly HeadsetTime[] _times = new HeadsetTime[Capacity];
        readonly double[] _sorted = new double[Capacity];
        int _next, _count;
        double _metresSd, _radiansSd;

        /// <summary>Whether enough was seen lately to say anything; what follows means something only then.</summary>
        public bool IsKnown { get; private set; }

        public double Metres { get; private set; }
        public double Radians { get; private set; }

        public void Clear()
        {
            _count = 0;
            IsKnown = false;
        }

        /// <param name="expected">Where the marker belongs.</param>
        /// <param name="seen">Where it is, in the same frame.</param>
        public void Add(in RigidTransform expected, in RigidTransform seen, HeadsetTime time)
        {
            var apart = expected.Inverse * seen;
            var (x, y, z) = apart.RotationVector();
            var at = _next * Numbers;
            (_values[at], _values[at + 1], _values[at + 2]) = (apart.X, apart.Y, apart.Z);
            (_values[at + 3], _values[at + 4], _values[at + 5]) = (x, y, z);
            _times[_next] = time;
            _next = (_next + 1) % Capacity;
            if (_count < Capacity) _count++;
            Update(time);
        }

        /// <summary>Beyond the limits by more than its own uncertainty.</summary>
        public bool IsBeyond(double metres, double radians) =>
            IsKnown && (Metres > metres + Sure * _metresSd || Radians > radians + Sure * _radiansSd);

        /// <summary>Clearly within the limits.</summary>
        public bool IsWithin(double metres, double radians) => IsKnown && Metres < 0.7 * metres && Radians < 0.7 * radians;

        void Update(HeadsetTime now)
        {
            var count = 0;
            while (count < _count && (now - TimeOf(count) <= Recent || (count < Least && now - TimeOf(count) <= Oldest))) count++;
            IsKnown = count >= Least;
            if (!IsKnown) return;
            (Metres, _metresSd) = Middle(count, 0);
            (Radians, _radiansSd) = Middle(count, 3);
        }

        (double Size, double Sd) Middle(int count, int first)
        {
            double size = 0, variance = 0;
            for (var number = first; number < first + 3; number++)
            {
                for (var back = 0; back < count; back++) _sorted[back] = _values[(_next - 1 - back + Capacity) % Capacity * Numbers + number];
                var middle = Median(count);
                for (var i = 0; i < count; i++) _sorted[i] = Math.Abs(_sorted[i] - middle);
                var sd = SdPerMedian * Median(count);
                size += middle * middle;
                variance += sd * sd / 3;
            }
            return (Math.Sqrt(size), MedianPerMean * Math.Sqrt(variance / count));
        }

        double Median(int count)
        {
            Array.Sort(_sorted, 0, count);
            return (_sorted[(count - 1) / 2] + _sorted[count / 2]) / 2;
        }

        HeadsetTime TimeOf(int back) => _times[(_next - 1 - back + Capacity) % Capacity];
    }
}
