using System;

namespace Nowpose.Prediction
{
    /// <summary>How often a joint is sampled and how fast it is known to move, from its samples. Allocates nothing once made.</summary>
    sealed class SamplePace
    {
        /// <summary>Share of a new interval: ten samples follow a source that was set to another rate.</summary>
        const double Share = 0.1;

        /// <summary>A longer pause says nothing about the sampling, s.</summary>
        const double LongestInterval = 0.5;

        double _time = double.NegativeInfinity;
        double _position;
        double _lastSpeed;

        /// <summary>T_s as observed, s; 0 before two samples.</summary>
        public double Interval { get; private set; }

        /// <summary>
        /// The greatest speed that two neighbouring intervals both had, rad/s or m/s; 0 before. One interval alone says
        /// nothing: a joint that is set elsewhere, or whose angle wraps from π to −π, has any speed for one.
        /// </summary>
        public double GreatestSpeed { get; private set; }

        /// <param name="time">s; what is not later than the newest is not looked at.</param>
        public void Add(double time, double position)
        {
            if (!(time > _time)) return;
            if (!double.IsNegativeInfinity(_time)) Measure(time - _time, Math.Abs(position - _position));
            _time = time;
            _position = position;
        }

        public void Clear()
        {
            _time = double.NegativeInfinity;
            Interval = GreatestSpeed = _lastSpeed = 0;
        }

        void Measure(double interval, double way)
        {
            var bounded = Math.Min(interval, LongestInterval);
            Interval = Interval == 0 ? bounded : Interval + Share * (bounded - Interval);
            var speed = way / interval;
            GreatestSpeed = Math.Max(GreatestSpeed, Math.Min(speed, _lastSpeed));
            _lastSpeed = speed;
        }
    }
}
