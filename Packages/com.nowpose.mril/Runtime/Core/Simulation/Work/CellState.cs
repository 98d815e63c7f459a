using System;
using System.Linq;
using Nowpose.Kinematics;

namespace Nowpose.Simulation.Work
{
    /// <summary>Part of the cell that holds a workpiece.</summary>
    enum Holder
    {
        Belt,
        Gripper,
        Fixture,
    }

    /// <summary>Place of a workpiece.</summary>
    readonly struct WorkpiecePlace
    {
        public WorkpiecePlace(Holder holder, int robot, double station = 0) => (Holder, Robot, Station) = (holder, robot, station);

        public Holder Holder { get; }

        /// <summary>Index of the robot that has the gripper or the fixture, or behind which the belt is.</summary>
        public int Robot { get; }

        /// <summary>Position on the belt when the belt was last at rest at a station; 0 at the fixture.</summary>
        public double Station { get; }
    }

    /// <summary>State of a robot and its gripper.</summary>
    readonly struct ArmState
    {
        public ArmState(int move, long start, bool closesGripper) => (Move, Start, ClosesGripper) = (move, start, closesGripper);

        /// <summary>Move or stroke of the robot, and the cycle in which it started.</summary>
        public int Move { get; }

        /// <inheritdoc cref="Move"/>
        public long Start { get; }

        /// <summary>Whether the gripper closes or has closed: the value of its signal, which changes at the start of a stroke.</summary>
        public bool ClosesGripper { get; }
    }

    /// <summary>
    /// State of a cell from one control cycle until the next change. Computes joints and poses at the times in between. Only the plant changes it, in
    /// the cycle of its creation.
    /// </summary>
    sealed class CellState
    {
        /// <summary>Duration of a control cycle, s.</summary>
        public const double CycleSeconds = 0.001;

        readonly CellLayout _layout;
        readonly ArmState[] _arms;
        readonly WorkpiecePlace[] _places;

        /// <summary>
        /// Creates the state at the start: the robots are at their first waypoint, and the stations of the belt have workpieces, from the pick place
        /// of the first robot backwards.
        /// </summary>
        /// <remarks>
        /// The first workpiece for a second robot has two stations to go. Thus the second robot picks later, and the robots do not go to the
        /// belt at the same time: the belt moves while one of them carries its workpiece.
        /// </remarks>
        public CellState(CellLayout layout)
        {
            _layout = layout;
            var arm = new ArmState(layout.Motion.MoveCount - 1, -CellPlant.CyclesOf(layout.Motion.CycleSeconds), closesGripper: false);
            _arms = Enumerable.Repeat(arm, layout.Robots.Length).ToArray();
            _places = Enumerable.Range(0, layout.Names.Count).Select(i => PlaceAtStart(i, layout.Robots.Length)).ToArray();
        }

        CellState(CellState other, long cycle)
        {
            _layout = other._layout;
            _arms = (ArmState[])other._arms.Clone();
            _places = (WorkpiecePlace[])other._places.Clone();
            Cycle = cycle;
            (IsBeltRunning, BeltStart, BeltSeconds) = (other.IsBeltRunning, other.BeltStart, other.BeltSeconds);
            PartsPresent = other.PartsPresent;
        }

        /// <summary>Number of the control cycle from which on this state is valid; cycle 0 is at the start.</summary>
        public long Cycle { get; }

        /// <summary>Whether the belt moves, the cycle in which it started, and the time that it had moved in this step before, s.</summary>
        public bool IsBeltRunning { get; private set; }

        /// <inheritdoc cref="IsBeltRunning"/>
        public long BeltStart { get; private set; }

        /// <inheritdoc cref="IsBeltRunning"/>
        public double BeltSeconds { get; private set; }

        /// <summary>Robots whose light barrier is interrupted: bit i for robot i.</summary>
        public int PartsPresent { get; set; }

        /// <summary>Returns a copy that becomes valid in a later cycle.</summary>
        public CellState CopyAt(long cycle) => new CellState(this, cycle);

        public ArmState ArmOf(int robot) => _arms[robot];

        public WorkpiecePlace PlaceOf(int workpiece) => _places[workpiece];

        public void Put(int workpiece, in WorkpiecePlace place) => _places[workpiece] = place;

        /// <summary>Starts a move, or the stroke of the gripper, of a robot.</summary>
        public void StartMove(int robot, int move, bool closesGripper) => _arms[robot] = new ArmState(move, Cycle, closesGripper);

        /// <summary>Starts or stops the belt, which continues its step later.</summary>
        public void SwitchBelt(bool isOn) => (IsBeltRunning, BeltStart, BeltSeconds) = (isOn, Cycle, BeltSecondsAt(Cycle * CycleSeconds));

        /// <summary>Ends a step of the belt: the next step starts from the present positions.</summary>
        public void EndBeltStep()
        {
            var stations = Enumerable.Range(0, _places.Length).Select(i => StationOf(i, Cycle * CycleSeconds)).ToArray();
            for (var i = 0; i < stations.Length; i++) _places[i] = new WorkpiecePlace(_places[i].Holder, _places[i].Robot, stations[i]);
            (IsBeltRunning, BeltSeconds) = (false, 0);
        }

        /// <summary>Returns the time for which the belt has moved in its step, s.</summary>
        public double BeltSecondsAt(double seconds) => BeltSeconds + (IsBeltRunning ? seconds - BeltStart * CycleSeconds : 0);

        /// <summary>Computes the joints of a robot, rad or m.</summary>
        /// <param name="seconds">Time since the start, s.</param>
        public void JointsAt(int robot, double seconds, Span<double> positions) =>
            _layout.Motion.At(_arms[robot].Move, seconds - _arms[robot].Start * CycleSeconds, positions);

        /// <summary>
        /// Returns the position of a workpiece on the belt. The first workpiece that arrives is held by the stop at the end of the belt, and the others
        /// queue behind it.
        /// </summary>
        /// <inheritdoc cref="JointsAt"/>
        public double StationOf(int workpiece, double seconds)
        {
            var place = _places[workpiece];
            if (place.Holder != Holder.Belt || BeltSecondsAt(seconds) == 0) return place.Station;
            var ahead = 0;
            for (var i = 0; i < _places.Length; i++)
                if (_places[i].Holder == Holder.Belt && _places[i].Robot == place.Robot && _places[i].Station > place.Station) ahead++;
            var belt = _layout.Robots[place.Robot].Belt;
            var queue = Math.Max(place.Station, CellLayout.Stations - ahead * belt.QueueDistance);
            return Math.Min(place.Station + belt.StepAt(BeltSecondsAt(seconds)), queue);
        }

        /// <summary>Returns the pose of a workpiece in its parent, and the parent's name.</summary>
        /// <inheritdoc cref="JointsAt"/>
        public RigidTransform PoseOf(int workpiece, double seconds, out string parent)
        {
            var place = _places[workpiece];
            var robot = _layout.Robots[place.Robot];
            switch (place.Holder)
            {
                case Holder.Gripper:
                    parent = robot.Tool;
                    return robot.InTool;
                case Holder.Fixture:
                    parent = robot.Fixture;
                    return robot.FixturePose.Inverse * robot.Placed;
                default:
                    parent = CellWork.Conveyor;
                    return _layout.ToConveyor * WorldOf(workpiece, seconds);
            }
        }

        /// <summary>Returns the pose of a workpiece in the world.</summary>
        /// <inheritdoc cref="JointsAt"/>
        public RigidTransform WorldOf(int workpiece, double seconds)
        {
            var place = _places[workpiece];
            var robot = _layout.Robots[place.Robot];
            return place.Holder == Holder.Gripper ? GraspOf(place.Robot, seconds) : robot.Belt.At(StationOf(workpiece, seconds));
        }

        /// <summary>Returns the pose in the world that a gripped workpiece has.</summary>
        /// <inheritdoc cref="JointsAt"/>
        public RigidTransform GraspOf(int robot, double seconds)
        {
            var joints = new double[_layout.Motion.JointNames.Count];
            JointsAt(robot, seconds, joints);
            var own = _layout.Robots[robot];
            return own.Base * own.ToolOf(joints) * own.InTool;
        }

        /// <summary>Gets the values of all signals of the layout, 0 or 1.</summary>
        public void GetSignals(Span<double> values)
        {
            var robots = _layout.Robots.Length;
            for (var i = 0; i < robots; i++)
            {
                values[i] = _arms[i].ClosesGripper ? 1 : 0;
                values[robots + 1 + i] = (PartsPresent >> i) & 1;
            }
            values[robots] = IsBeltRunning ? 1 : 0;
        }

        // The belt behind the last robot leads to the first robot. The next belt has no workpieces at its last two stations.
        static WorkpiecePlace PlaceAtStart(int workpiece, int robots)
        {
            const int places = CellLayout.Stations + 1, free = 2;
            var place = workpiece < places ? workpiece : workpiece + free;
            return new WorkpiecePlace(Holder.Belt, (robots - 1 + place / places) % robots, CellLayout.Stations - place % places);
        }
    }
}
