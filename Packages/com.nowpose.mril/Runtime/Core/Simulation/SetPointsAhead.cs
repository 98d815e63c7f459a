using System;
using System.Collections.Generic;
using Nowpose.Motion;
using Nowpose.Protocol;

namespace Nowpose.Simulation
{
    /// <summary>What a planner publishes of a motion: the set-points of the next moments, with velocities and accelerations.</summary>
    sealed class SetPointsAhead
    {
        /// <summary>From one message to the next: often enough that what it says never runs out.</summary>
        public static readonly TimeSpan Interval = new TimeSpan(TimeSpan.TicksPerSecond / 4);

        /// <summary>How far a message reaches, s.</summary>
        const double Span = 1;

        /// <summary>From one set-point to the next, s: what a motion planner's time parameterisation usually has, or finer.</summary>
        const double Step = 0.05;

        /// <summary>Of the differences that velocity and acceleration are made of, s.</summary>
        const double Difference = 1e-3;

        readonly IMotion _motion;
        readonly string[] _names;
        readonly double[] _before;
        readonly double[] _after;

        public SetPointsAhead(IMotion motion)
        {
            _motion = motion;
            _names = new List<string>(motion.JointNames).ToArray();
            _before = new double[_names.Length];
            _after = new double[_names.Length];
        }

        /// <param name="stamp">When the first set-point is due.</param>
        /// <param name="seconds">The motion's time then.</param>
        public JointTrajectoryMessage At(ControlTime stamp, double seconds)
        {
            var points = new JointTrajectoryPoint[(int)Math.Round(Span / Step) + 1];
            for (var i = 0; i < points.Length; i++) points[i] = PointAt(seconds + i * Step, ClockTicks.Span(i * Step));
            return new JointTrajectoryMessage(stamp, _names, points);
        }

        JointTrajectoryPoint PointAt(double seconds, TimeSpan fromStart)
        {
            var (positions, velocities, accelerations) = (new double[_names.Length], new double[_names.Length], new double[_names.Length]);
            _motion.At(seconds, positions);
            _motion.At(seconds - Difference, _before);
            _motion.At(seconds + Difference, _after);
            for (var i = 0; i < positions.Length; i++)
            {
                velocities[i] = (_after[i] - _before[i]) / (2 * Difference);
                accelerations[i] = (_after[i] - 2 * positions[i] + _before[i]) / (Difference * Difference);
            }
            return new JointTrajectoryPoint(fromStart, positions, velocities, accelerations);
        }
    }
}
