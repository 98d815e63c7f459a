using System;
using System.Collections.Generic;

namespace Nowpose.Motion
{
    /// <summary>A straight move in joint space from rest to rest; all joints start and stop together.</summary>
    sealed class JointMove
    {
        readonly double[] _from;
        readonly double[] _to;
        readonly SevenPhaseProfile _share;

        public JointMove(double[] from, double[] to, IReadOnlyList<DriveLimits> limits)
        {
            _from = from;
            _to = to;
            // One profile for the fraction of the path. Each of its limits is the minimum of limit ÷ path length over all joints, so every joint
            // always stays within its own limits.
            double velocity = double.PositiveInfinity, acceleration = double.PositiveInfinity, jerk = double.PositiveInfinity;
            for (var i = 0; i < from.Length; i++)
            {
                var way = Math.Abs(to[i] - from[i]);
                if (way == 0)
                    continue;
                velocity = Math.Min(velocity, limits[i].Velocity / way);
                acceleration = Math.Min(acceleration, limits[i].Acceleration / way);
                jerk = Math.Min(jerk, limits[i].Jerk / way);
            }

            if (!double.IsInfinity(velocity))
                _share = new SevenPhaseProfile(1, velocity, acceleration, jerk);
        }

        /// <summary>Duration in s; zero if no joint moves.</summary>
        public double Duration => _share.Duration;

        /// <param name="seconds">Time since the move's start, in s.</param>
        public void At(double seconds, Span<double> positions)
        {
            var share = _share.PositionAt(seconds);
            for (var i = 0; i < _from.Length; i++)
                positions[i] = _from[i] + share * (_to[i] - _from[i]);
        }
    }
}
