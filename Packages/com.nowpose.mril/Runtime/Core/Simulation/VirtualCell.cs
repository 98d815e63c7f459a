using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation.Work;

namespace Nowpose.Simulation
{
    /// <summary>
    /// A control system with its robots and a network, in one process and without sockets. Feeds a session as a gateway does, and computes
    /// the robots' true positions. Deterministic: the same seed and times give the same run. Not thread-safe.
    /// </summary>
    /// <remarks>Settings and clock may change at run time; packets in transit keep their arrival times.</remarks>
    public sealed class VirtualCell
    {
        /// <summary>
        /// Maximum interval that one call simulates. If more time has passed since the last call, the events before this interval are lost, as if
        /// the headset had been asleep.
        /// </summary>
        static readonly TimeSpan MaxPause = TimeSpan.FromSeconds(2);

        readonly IReadOnlyList<(string Namespace, IMotion Motion)> _robots;
        readonly HeadsetTime _start;
        readonly VirtualSamples _samples;
        readonly VirtualExchanges _exchanges;
        readonly VirtualPlans _plans;
        readonly VirtualWork _work;
        VirtualCellSettings _settings;

        /// <param name="clock">The control clock.</param>
        /// <param name="seed">Seed of all delays and losses.</param>
        /// <param name="start">Start of the motion.</param>
        public VirtualCell(IMotion motion, VirtualClock clock, VirtualCellSettings settings, int seed, HeadsetTime start)
            : this(new CellMotion(motion), clock, settings, seed, start)
        {
        }

        /// <summary>Creates a cell with any number of robots, which may move workpieces.</summary>
        /// <inheritdoc cref="VirtualCell(IMotion, VirtualClock, VirtualCellSettings, int, HeadsetTime)"/>
        /// <param name="exchangeClock">The clock that answers the sync exchanges, if it differs from the control clock.</param>
        internal VirtualCell(
            CellMotion motion, VirtualClock clock, VirtualCellSettings settings, int seed, HeadsetTime start, VirtualClock exchangeClock = null)
        {
            _robots = motion.Motions;
            _start = start;
            _samples = new VirtualSamples(_robots, clock, unchecked(seed * 100), start);
            _exchanges = new VirtualExchanges(exchangeClock ?? clock, unchecked(seed * 100 + 50), start);
            _plans = new VirtualPlans(_robots, clock, unchecked(seed * 100 + 70), start);
            _work = motion.Work == null ? null : new VirtualWork(motion.Work, clock, unchecked(seed * 100 + 90), start);
            Settings = settings;
        }

        /// <summary>
        /// Creates a cell with workpieces: a conveyor brings them, and the robot puts them on a fixture. A control program with a cycle of 1 ms reads
        /// light barrier, gripper, fixture and arm, and switches belt, gripper and moves. The cell sends the frames
        /// <c>conveyor</c>, <c>fixture</c> and <c>workpiece_1</c> to <c>workpiece_3</c>, and the signals <c>gripper_closed</c>,
        /// <c>belt_running</c> and <c>part_present</c>.
        /// </summary>
        /// <inheritdoc cref="VirtualCell(IMotion, VirtualClock, VirtualCellSettings, int, HeadsetTime)"/>
        /// <param name="robots">
        /// Number of robots, 1 or 2. Two robots share the conveyor, and each has its own control program. They have the namespaces <c>arm1</c> and
        /// <c>arm2</c>, a frame for each base, the fixtures <c>fixture_1</c> and <c>fixture_2</c>, six workpieces, and the signals
        /// <c>gripper_closed_1</c>, <c>gripper_closed_2</c>, <c>part_present_1</c> and <c>part_present_2</c>.
        /// </param>
        public static VirtualCell WithWorkpieces(
            RobotModel robot, PickAndPlaceMotion motion, VirtualClock clock, VirtualCellSettings settings, int seed, HeadsetTime start,
            int robots = 1) =>
            new VirtualCell(new CellMotion(new CellWork(robot, motion, robots)), clock, settings, seed, start);

        /// <exception cref="InputException">The settings are <c>default</c>.</exception>
        public VirtualCellSettings Settings
        {
            get => _settings;
            set => _settings = value.Network != null ? value : throw new InputException(SettingMessages.DefaultCellSettings);
        }

        /// <summary>Delay of the robots behind their set-points; null if they publish none. A change takes effect within 0.25 s.</summary>
        public TimeSpan? PlanLag { get; set; }

        /// <summary>Passes the messages that have arrived to the session. Allocates only the messages.</summary>
        /// <param name="now">Current time, not before the time in the last call.</param>
        /// <param name="session">The session, which may differ from the session in the last call.</param>
        public void Run(HeadsetTime now, CompensationSession session)
        {
            var from = now - MaxPause;
            _exchanges.Run(from, now, Settings, session);
            _samples.Run(from, now, Settings, session);
            _work?.Run(from, now, Settings, session);
            _plans.Run(from, now, PlanLag, Settings, session);
        }

        /// <summary>Computes the true position of a robot. Allocates nothing, except when a cell with workpieces changes.</summary>
        /// <param name="t">
        /// Time, at most seconds after the last one: a cell with workpieces is first simulated until then, in up to 1 s for each hour.
        /// </param>
        /// <param name="joints">Receives one position per joint of the motion, rad or m.</param>
        /// <param name="robot">Index of the robot, 0 for the first one and 1 for the second one.</param>
        /// <exception cref="ArgumentOutOfRangeException">The cell has no robot with this index.</exception>
        public void TruthAt(HeadsetTime t, Span<double> joints, int robot = 0)
        {
            if (robot < 0 || robot >= _robots.Count) throw new ArgumentOutOfRangeException(nameof(robot), robot, null);
            _robots[robot].Motion.At(ClockTicks.Seconds(t - _start), joints);
        }
    }
}
