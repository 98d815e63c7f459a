using System;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>
    /// Remembers which samples a joint has had lately, to know one that is sent again and one that cannot be from then. Allocates
    /// nothing once made.
    /// </summary>
    sealed class RecentSamples
    {
        /// <summary>A quarter of a second at 1 kHz, 2.5 s at 100 Hz.</summary>
        const int Capacity = 256;

        /// <summary>As where samples are kept for a prediction, s.</summary>
        const double SameSeconds = 1e-6;

        /// <summary>
        /// Of the way between the samples around: an overtaken sample lies off the line between its neighbours by less, in a turn
        /// too; one of a clock that went back by two intervals, by twice that way.
        /// </summary>
        const double GreatestShareOfWay = 1.5;

        readonly double[] _orders = new double[Capacity];
        readonly double[] _positions = new double[Capacity];
        int _next;
        int _count;

        public void Add(in JointSample sample)
        {
            _orders[_next] = sample.Order;
            _positions[_next] = sample.Position;
            _next = (_next + 1) % Capacity;
            if (_count < Capacity) _count++;
        }

        public bool Contains(in JointSample sample)
        {
            for (var i = 0; i < _count; i++)
                if (IsSame(_orders[i], _positions[i], sample)) return true;
            return false;
        }

        /// <summary>Whether the samples before and after say that the joint was elsewhere then; false where they are not known.</summary>
        public bool Contradict(in JointSample sample)
        {
            var before = Neighbour(sample.Order, -1);
            var after = Neighbour(sample.Order, 1);
            if (before < 0 || after < 0) return false;
            var way = _positions[after] - _positions[before];
            var onLine = _positions[before] + way * (sample.Order - _orders[before]) / (_orders[after] - _orders[before]);
            var greatest = Math.Max(Math.Abs(way), Math.Max(WayFrom(before, -1), WayFrom(after, 1)));
            return Math.Abs(sample.Position - onLine) > GreatestShareOfWay * greatest;
        }

        public void Clear() => _next = _count = 0;

        /// <summary>
        /// Whether a sample is one sent again. The stamp alone does not tell: a clock that goes back by whole sampling intervals
        /// repeats those of before, with other positions.
        /// </summary>
        public static bool IsSame(double order, double position, in JointSample sample) =>
            Math.Abs(order - sample.Order) < SameSeconds && position == sample.Position;

        double WayFrom(int index, int direction)
        {
            var next = Neighbour(_orders[index], direction);
            return next < 0 ? 0 : Math.Abs(_positions[next] - _positions[index]);
        }

        // The nearest one strictly before, -1, or after, 1; -1 where there is none.
        int Neighbour(double order, int direction)
        {
            var nearest = -1;
            for (var i = 0; i < _count; i++)
            {
                var distance = direction * (_orders[i] - order);
                if (distance > 0 && (nearest < 0 || distance < direction * (_orders[nearest] - order))) nearest = i;
            }
            return nearest;
        }
    }
}
