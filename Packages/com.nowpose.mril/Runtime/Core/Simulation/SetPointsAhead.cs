using System;
using System.Collections.Generic;
using Nowpose.Motion;
using Nowpose.Protocol;

namespace Nowpose.Simulation
{
    /// <summary>Generates messages as a motion planner publishes them: the next set-points of a motion, with velocities and accelerations.</summary>
    sealed class SetPointsAhead
    {
        /// <summary>Interval between messages. It is short enough that the set-points never run out.</summary>
        public static readonly TimeSpan Interval = new TimeSpan(TimeSpan.TicksPerSecond / 4);

        /// <summary>Time span of the set-points of a message, in s.</summary>
        const double Span = 1;

        /// <summary>
        /// Interval between set-points, in s. Motion planners typically use this interval or a longer one for time parameterisation.
        /// </summary>
        const double Step = 0.05;

        /// <summary>Step of the difference quotients for velocity and acceleration, in s.</summary>
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

        /// <param name="stamp">Control time of the first set-point.</param>
        /// <param name="seconds">Time of the motion at that set-point, in s.</param>
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
