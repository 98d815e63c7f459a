using System;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>
    /// The mechanical parts of a cell: robots, grippers, belt, fixtures and workpieces. They follow the outputs of the control program and give its
    /// inputs.
    /// </summary>
    sealed class CellPlant
    {
        /// <summary>Maximum distance of a workpiece from the middle of the gripper that takes it, m.</summary>
        const double Reach = CellWork.Size / 2;

        static readonly long ClampCycles = CyclesOf(CellLayout.ClampSeconds);

        readonly CellLayout _layout;
        readonly long[] _moveCycles;
        CellInputs _inputs;
        // The last outputs.
        readonly int[] _moves;
        bool _runsBelt;
        long _cycle;
        // Cycle in which the clamps of the fixtures started to open; null while they are closed.
        long? _opened;

        public CellPlant(CellLayout layout)
        {
            _layout = layout;
            State = new CellState(layout);
            _inputs.Arms = new ArmInputs[layout.Robots.Length];
            _moves = Enumerable.Range(0, layout.Robots.Length).Select(i => State.ArmOf(i).Move).ToArray();
            _moveCycles = Enumerable.Range(0, layout.Motion.MoveCount).Select(move => CyclesOfMove(layout.Motion, move)).ToArray();
        }

        /// <summary>Returns the number of control cycles after which a process has ended.</summary>
        /// <param name="seconds">Duration of the process, s. Rounding errors do not lengthen it.</param>
        public static long CyclesOf(double seconds) => (long)Math.Ceiling(seconds / CellState.CycleSeconds - 1e-6);

        /// <summary>Returns the number of control cycles of a move. The program starts at most one move in a cycle.</summary>
        public static long CyclesOfMove(PickAndPlaceMotion motion, int move) => Math.Max(1, CyclesOf(motion.SecondsOf(move)));

        /// <summary>The newest state. A change creates a new object.</summary>
        public CellState State { get; private set; }

        /// <summary>Whether the belt is blocked: it does not move while it is switched on. From the next cycle on.</summary>
        public bool IsBeltBlocked { get; set; }

        double Now => _cycle * CellState.CycleSeconds;

        /// <summary>Moves a workpiece by hand, from the next cycle on.</summary>
        public void Put(int workpiece, in WorkpiecePlace place) => (State = State.CopyAt(_cycle + 1)).Put(workpiece, place);

        /// <summary>Reads the sensors at the beginning of a control cycle. The next call changes the result.</summary>
        public CellInputs Sense(long cycle)
        {
            _cycle = cycle;
            var (present, occupied) = Workpieces();
            if (present != State.PartsPresent) Changed().PartsPresent = present;
            for (var i = 0; i < _inputs.Arms.Length; i++)
            {
                var arm = State.ArmOf(i);
                var hasEnded = cycle - arm.Start >= _moveCycles[arm.Move];
                _inputs.Arms[i] = new ArmInputs
                {
                    IsPartPresent = (present >> i & 1) != 0,
                    IsFixtureFree = (occupied >> i & 1) == 0,
                    IsAtRest = hasEnded,
                    IsGripperClosed = arm.ClosesGripper && hasEnded,
                    IsGripperOpen = !arm.ClosesGripper && hasEnded,
                };
            }
            _inputs.AreClampsOpen = cycle - _opened >= ClampCycles;
            _inputs.IsBeltAtStation = State.BeltSecondsAt(Now) >= _layout.BeltStepSeconds;
            return _inputs;
        }

        /// <summary>Follows the outputs at the end of a control cycle.</summary>
        public void Follow(in CellOutputs outputs)
        {
            for (var i = 0; i < outputs.Arms.Length; i++) Follow(i, outputs.Arms[i]);
            if (outputs.OpensClamps != _opened.HasValue) MoveClamps(outputs.OpensClamps);
            var isMoving = outputs.RunsBelt && !IsBeltBlocked;
            if (isMoving != State.IsBeltRunning) Changed().SwitchBelt(isMoving);
            if (_runsBelt && !outputs.RunsBelt) Changed().EndBeltStep();
            _runsBelt = outputs.RunsBelt;
        }

        // The fingers of a robot are joints that move in its grip and its release. The fingers hold the workpiece from the start of the stroke on.
        void Follow(int robot, in ArmOutputs outputs)
        {
            var closes = outputs.ClosesGripper;
            if (closes != State.ArmOf(robot).ClosesGripper)
            {
                if (closes) Grip(robot);
                else PassOn(Holder.Gripper, Holder.Fixture, robot);
                Changed().StartMove(robot, closes ? _layout.Motion.Task.Grip : _layout.Motion.Task.Release, closes);
            }
            else if (outputs.Move != _moves[robot]) Changed().StartMove(robot, outputs.Move, closes);
            _moves[robot] = outputs.Move;
        }

        CellState Changed() => State.Cycle == _cycle ? State : State = State.CopyAt(_cycle);

        void Grip(int robot)
        {
            var state = Changed();
            var grasp = state.GraspOf(robot, Now);
            for (var i = 0; i < _layout.Names.Count; i++)
                if (state.WorldOf(i, Now).DistanceTo(grasp) < Reach) state.Put(i, new WorkpiecePlace(Holder.Gripper, robot));
        }

        // An open clamp leaves its workpiece on the start of the belt.
        void MoveClamps(bool open)
        {
            _opened = open ? _cycle : (long?)null;
            for (var i = 0; open && i < _layout.Robots.Length; i++) PassOn(Holder.Fixture, Holder.Belt, i);
        }

        // Passes the workpieces from one part of the cell to another one of the same robot.
        void PassOn(Holder from, Holder to, int robot)
        {
            for (var i = 0; i < _layout.Names.Count; i++)
                if (State.PlaceOf(i) is var place && place.Holder == from && place.Robot == robot) Changed().Put(i, new WorkpiecePlace(to, robot));
        }

        // Returns the robots whose light barrier is interrupted, and the robots whose fixture is occupied: bit i for robot i.
        (int PartsPresent, int Occupied) Workpieces()
        {
            var (present, occupied) = (0, 0);
            for (var i = 0; i < _layout.Names.Count; i++)
            {
                var place = State.PlaceOf(i);
                if (place.Holder == Holder.Fixture) occupied |= 1 << place.Robot;
                if (place.Holder != Holder.Belt) continue;
                var station = State.StationOf(i, Now);
                if (station >= CellLayout.Stations) present |= 1 << _layout.Next(place.Robot);
                if (station < _layout.Robots[place.Robot].Belt.QueueDistance) occupied |= 1 << place.Robot;
            }
            return (present, occupied);
        }
    }
}
