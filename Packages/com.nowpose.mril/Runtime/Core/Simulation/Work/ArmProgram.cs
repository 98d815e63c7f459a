using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>Sensors and feedback of one robot that its control program reads at the beginning of a cycle.</summary>
    struct ArmInputs
    {
        /// <summary>Whether a workpiece interrupts the light barrier at the pick place.</summary>
        public bool IsPartPresent { get; set; }

        /// <summary>Whether the fixture is free.</summary>
        public bool IsFixtureFree { get; set; }

        /// <summary>Whether the robot has finished its last move.</summary>
        public bool IsAtRest { get; set; }

        /// <summary>Whether the gripper has closed, or opened, after its stroke.</summary>
        public bool IsGripperClosed { get; set; }

        /// <inheritdoc cref="IsGripperClosed"/>
        public bool IsGripperOpen { get; set; }
    }

    /// <summary>Commands that the control program of one robot sets at the end of a cycle.</summary>
    struct ArmOutputs
    {
        /// <summary>Move of the robot. A change starts the move.</summary>
        public int Move { get; set; }

        /// <summary>True to close the gripper, false to open it.</summary>
        public bool ClosesGripper { get; set; }
    }

    /// <summary>
    /// Control program of one robot. It runs in each control cycle, and decides from its inputs, its step and the state of the belt only.
    /// </summary>
    sealed class ArmProgram
    {
        readonly TaskMoves _task;
        readonly int _moves;
        // The move or stroke that was started last.
        int _step;
        ArmOutputs _outputs;

        /// <param name="moves">Number of moves in a cycle.</param>
        public ArmProgram(in TaskMoves task, int moves)
        {
            _task = task;
            _moves = moves;
            _step = _outputs.Move = moves - 1;
        }

        /// <summary>Whether the gripper carries a workpiece between pick place and fixture.</summary>
        public bool IsCarrying => _task.IsCarrying(_step);

        /// <summary>
        /// Whether the belt must not start: the gripper is at the pick place or at the fixture, or on its way to a workpiece that is present, for which it
        /// would otherwise have to wait.
        /// </summary>
        public bool BlocksBelt(in ArmInputs inputs) => _task.IsAtBelt(_step) || (_step < _task.Approach && inputs.IsPartPresent);

        /// <summary>Runs one control cycle.</summary>
        /// <param name="isBeltAtRest">Whether the belt is at rest and the clamps are closed.</param>
        public ArmOutputs Run(in ArmInputs inputs, bool isBeltAtRest)
        {
            var next = (_step + 1) % _moves;
            if (!HasEnded(_step, inputs) || !MayStart(next, inputs, isBeltAtRest)) return _outputs;
            _step = next;
            if (next == _task.Grip) _outputs.ClosesGripper = true;
            else if (next == _task.Release) _outputs.ClosesGripper = false;
            else _outputs.Move = next;
            return _outputs;
        }

        bool HasEnded(int step, in ArmInputs inputs) =>
            step == _task.Grip ? inputs.IsGripperClosed : step == _task.Release ? inputs.IsGripperOpen : inputs.IsAtRest;

        // If the workpiece disappears during the approach, the gripper closes on nothing: the belt cannot bring the next one before it has left.
        bool MayStart(int step, in ArmInputs inputs, bool isBeltAtRest)
        {
            if (step == _task.Approach) return isBeltAtRest && inputs.IsPartPresent;
            return step != _task.Lower || isBeltAtRest && inputs.IsFixtureFree;
        }
    }
}
