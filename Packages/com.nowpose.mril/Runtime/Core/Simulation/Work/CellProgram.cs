using System.Linq;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>Sensors and feedback that the control program reads at the beginning of a cycle.</summary>
    struct CellInputs
    {
        /// <summary>The inputs of each robot.</summary>
        public ArmInputs[] Arms { get; set; }

        /// <summary>Whether the clamp of each fixture has opened.</summary>
        public bool AreClampsOpen { get; set; }

        /// <summary>Whether the belt has moved by one station since its start.</summary>
        public bool IsBeltAtStation { get; set; }
    }

    /// <summary>Commands that the control program sets at the end of a cycle.</summary>
    struct CellOutputs
    {
        /// <summary>The outputs for each robot.</summary>
        public ArmOutputs[] Arms { get; set; }

        /// <summary>True to open the clamps of the fixtures, so that their workpieces lie on the belt.</summary>
        public bool OpensClamps { get; set; }

        /// <summary>Whether the belt is switched on.</summary>
        public bool RunsBelt { get; set; }
    }

    /// <summary>
    /// Control program of a cell: one sequence for each robot, and one for the conveyor that they share. It runs in each control cycle. The belt
    /// does not start while a gripper is at it, and the robots do not pick up or put down workpieces before it is at rest.
    /// </summary>
    sealed class CellProgram
    {
        readonly ArmProgram[] _arms;
        CellOutputs _outputs;

        /// <param name="moves">Number of moves in a cycle.</param>
        /// <param name="robots">Number of robots.</param>
        public CellProgram(TaskMoves task, int moves, int robots)
        {
            _arms = Enumerable.Range(0, robots).Select(_ => new ArmProgram(task, moves)).ToArray();
            _outputs.Arms = new ArmOutputs[robots];
        }

        /// <summary>Runs one control cycle. The next call changes the result.</summary>
        public CellOutputs Run(in CellInputs inputs)
        {
            RunBelt(inputs);
            for (var i = 0; i < _arms.Length; i++) _outputs.Arms[i] = _arms[i].Run(inputs.Arms[i], isBeltAtRest: !_outputs.OpensClamps);
            return _outputs;
        }

        void RunBelt(in CellInputs inputs)
        {
            if (_outputs.RunsBelt)
            {
                if (inputs.IsBeltAtStation) _outputs.RunsBelt = _outputs.OpensClamps = false;
            }
            else if (_outputs.OpensClamps) _outputs.RunsBelt = inputs.AreClampsOpen;
            else _outputs.OpensClamps = MayStartBelt(inputs);
        }

        // The belt brings the next workpiece while another robot still carries one, so that neither has to wait for it. If all robots carry workpieces, it
        // only moves to free a fixture: otherwise it would move again before they have put them down.
        bool MayStartBelt(in CellInputs inputs)
        {
            var (isAway, isPartMissing, isFixtureNeeded) = (false, false, false);
            for (var i = 0; i < _arms.Length; i++)
            {
                if (_arms[i].BlocksBelt(inputs.Arms[i])) return false;
                isAway |= !_arms[i].IsCarrying;
                isPartMissing |= !inputs.Arms[i].IsPartPresent;
                isFixtureNeeded |= _arms[i].IsCarrying && !inputs.Arms[i].IsFixtureFree;
            }
            return isAway && isPartMissing || isFixtureNeeded;
        }
    }
}
