using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>Sensors and feedback that the control program reads at the beginning of a cycle.</summary>
    struct CellInputs
    {
        /// <summary>Whether a workpiece interrupts the light barrier at the pick place of each robot.</summary>
        public bool ArePartsPresent { get; set; }

        /// <summary>Whether the fixture of each robot is free.</summary>
        public bool AreFixturesFree { get; set; }

        /// <summary>Whether the clamp of each fixture has opened.</summary>
        public bool AreClampsOpen { get; set; }

        /// <summary>Whether the belt has moved by one station since its start.</summary>
        public bool IsBeltAtStation { get; set; }

        /// <summary>Whether each robot has finished its last move.</summary>
        public bool AreRobotsAtRest { get; set; }

        /// <summary>Whether each gripper has closed, or opened, after its stroke.</summary>
        public bool AreGrippersClosed { get; set; }

        /// <inheritdoc cref="AreGrippersClosed"/>
        public bool AreGrippersOpen { get; set; }
    }

    /// <summary>Commands that the control program sets at the end of a cycle.</summary>
    struct CellOutputs
    {
        /// <summary>Move of the robots. A change starts the move.</summary>
        public int Move { get; set; }

        /// <summary>True to close the grippers, false to open them.</summary>
        public bool ClosesGrippers { get; set; }

        /// <summary>True to open the clamps of the fixtures, so that their workpieces lie on the belt.</summary>
        public bool OpensClamps { get; set; }

        /// <summary>Whether the belt is switched on.</summary>
        public bool RunsBelt { get; set; }
    }

    /// <summary>
    /// Control program of a cell: two sequences, one for the belt and one for the robots. It runs in each control cycle, and decides from its inputs,
    /// its step and its last outputs only. All robots do the same step; each step waits for all of them.
    /// </summary>
    sealed class CellProgram
    {
        readonly TaskMoves _task;
        readonly int _moves;
        // The robots' step: the move or stroke that was started last.
        int _step;
        CellOutputs _outputs;

        /// <param name="moves">Number of moves in a cycle.</param>
        public CellProgram(in TaskMoves task, int moves)
        {
            _task = task;
            _moves = moves;
            _step = _outputs.Move = moves - 1;
        }

        /// <summary>Runs one control cycle.</summary>
        public CellOutputs Run(in CellInputs inputs)
        {
            RunBelt(inputs);
            RunRobots(inputs);
            return _outputs;
        }

        // The belt moves by one station if a pick place is empty and the robots do a move during which it may start, see TaskMoves.
        void RunBelt(in CellInputs inputs)
        {
            if (_outputs.RunsBelt)
            {
                if (inputs.IsBeltAtStation) _outputs.RunsBelt = _outputs.OpensClamps = false;
            }
            else if (_outputs.OpensClamps) _outputs.RunsBelt = inputs.AreClampsOpen;
            else _outputs.OpensClamps = (_step >= _task.Leave || _step < _task.Approach) && !inputs.ArePartsPresent;
        }

        void RunRobots(in CellInputs inputs)
        {
            var next = (_step + 1) % _moves;
            if (!HasEnded(_step, inputs) || !MayStart(next, inputs)) return;
            _step = next;
            if (next == _task.Grip) _outputs.ClosesGrippers = true;
            else if (next == _task.Release) _outputs.ClosesGrippers = false;
            else _outputs.Move = next;
        }

        bool HasEnded(int step, in CellInputs inputs) =>
            step == _task.Grip ? inputs.AreGrippersClosed : step == _task.Release ? inputs.AreGrippersOpen : inputs.AreRobotsAtRest;

        bool MayStart(int step, in CellInputs inputs)
        {
            if (step == _task.Approach || step == _task.Grip) return inputs.ArePartsPresent && !_outputs.OpensClamps;
            return step != _task.Lower || inputs.AreFixturesFree;
        }
    }
}
