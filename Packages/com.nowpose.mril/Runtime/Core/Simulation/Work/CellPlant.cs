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
        CellOutputs _outputs;
        long _cycle;
        // Cycle in which the clamps of the fixtures started to open; null while they are closed.
        long? _opened;

        public CellPlant(CellLayout layout)
        {
            _layout = layout;
            State = new CellState(layout);
            _outputs.Move = State.Move;
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

        /// <summary>Reads the sensors at the beginning of a control cycle.</summary>
        public CellInputs Sense(long cycle)
        {
            _cycle = cycle;
            var (present, areFixturesFree) = Workpieces();
            if (present != State.PartsPresent) Changed().PartsPresent = present;
            var hasEnded = cycle - State.MoveStart >= _moveCycles[State.Move];
            return new CellInputs
            {
                ArePartsPresent = present == (1 << _layout.Robots.Length) - 1,
                AreFixturesFree = areFixturesFree,
                AreClampsOpen = cycle - _opened >= ClampCycles,
                IsBeltAtStation = State.BeltSecondsAt(Now) >= _layout.BeltStepSeconds,
                AreRobotsAtRest = hasEnded,
                AreGrippersClosed = State.ClosesGrippers && hasEnded,
                AreGrippersOpen = !State.ClosesGrippers && hasEnded,
            };
        }

        /// <summary>Follows the outputs at the end of a control cycle.</summary>
        public void Follow(in CellOutputs outputs)
        {
            if (outputs.Move != _outputs.Move) Changed().StartMove(outputs.Move);
            if (outputs.ClosesGrippers != State.ClosesGrippers) MoveGrippers(outputs.ClosesGrippers);
            if (outputs.OpensClamps != _opened.HasValue) MoveClamps(outputs.OpensClamps);
            var isMoving = outputs.RunsBelt && !IsBeltBlocked;
            if (isMoving != State.IsBeltRunning) Changed().SwitchBelt(isMoving);
            if (_outputs.RunsBelt && !outputs.RunsBelt) Changed().EndBeltStep();
            _outputs = outputs;
        }

        CellState Changed() => State.Cycle == _cycle ? State : State = State.CopyAt(_cycle);

        // The fingers of a robot are joints that move in its grip and its release. The fingers hold the workpiece from the start of the stroke on.
        void MoveGrippers(bool close)
        {
            var state = Changed();
            if (close)
                for (var i = 0; i < _layout.Robots.Length; i++) Grip(i, state);
            else
                PassOn(Holder.Gripper, Holder.Fixture);
            state.ClosesGrippers = close;
            state.StartMove(close ? _layout.Motion.Task.Grip : _layout.Motion.Task.Release);
        }

        void Grip(int robot, CellState state)
        {
            var grasp = state.GraspOf(_layout.Robots[robot], Now);
            for (var i = 0; i < _layout.Names.Count; i++)
                if (state.WorldOf(i, Now).DistanceTo(grasp) < Reach) state.Put(i, new WorkpiecePlace(Holder.Gripper, robot));
        }

        // An open clamp leaves its workpiece on the start of the belt.
        void MoveClamps(bool open)
        {
            _opened = open ? _cycle : (long?)null;
            if (open) PassOn(Holder.Fixture, Holder.Belt);
        }

        // Passes the workpieces from one part of the cell to another one of the same robot.
        void PassOn(Holder from, Holder to)
        {
            for (var i = 0; i < _layout.Names.Count; i++)
                if (State.PlaceOf(i).Holder == from) Changed().Put(i, new WorkpiecePlace(to, State.PlaceOf(i).Robot));
        }

        // Returns the robots whose light barrier is interrupted, bit i for robot i, and whether all fixtures are free.
        (int PartsPresent, bool AreFixturesFree) Workpieces()
        {
            var (present, areFree) = (0, true);
            for (var i = 0; i < _layout.Names.Count; i++)
            {
                var place = State.PlaceOf(i);
                if (place.Holder == Holder.Fixture) areFree = false;
                if (place.Holder != Holder.Belt) continue;
                var station = State.StationOf(i, Now);
                if (station >= CellLayout.Stations) present |= 1 << _layout.Next(place.Robot);
                if (station < _layout.Robots[place.Robot].Belt.QueueDistance) areFree = false;
            }
            return (present, areFree);
        }
    }
}
