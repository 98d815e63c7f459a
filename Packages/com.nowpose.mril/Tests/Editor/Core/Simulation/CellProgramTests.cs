using Nowpose.Motion;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests the control program with given inputs, without a plant.</summary>
    public class CellProgramTests
    {
        const int Moves = 9;

        static readonly TaskMoves Task = new TaskMoves(approach: 1, grip: 2, lower: 5, release: 6);

        readonly CellInputs _ready = new CellInputs
        {
            ArePartsPresent = true, AreFixturesFree = true, AreRobotsAtRest = true, AreGrippersOpen = true, AreGrippersClosed = true,
        };

        CellProgram _program;
        CellOutputs _outputs;

        [SetUp]
        public void Start() => _program = new CellProgram(Task, Moves);

        [Test]
        public void Run_AllInputsSet_StartsEachMoveInTurnAndSwitchesTheGrippers()
        {
            for (var cycle = 0; cycle < 3 * Moves; cycle++)
            {
                _outputs = _program.Run(_ready);
                var step = cycle % Moves;
                if (step != Task.Grip && step != Task.Release) Assert.That(_outputs.Move, Is.EqualTo(step));
                Assert.That(_outputs.ClosesGrippers, Is.EqualTo(step >= Task.Grip && step < Task.Release));
                Assert.That(_outputs.RunsBelt, Is.False, "the parts are present");
            }
        }

        [Test]
        public void Run_RobotsMove_StartsNoMove()
        {
            Run(_ready, cycles: 1);
            var moving = _ready;
            moving.AreRobotsAtRest = false;

            Run(moving, cycles: 100);

            Assert.That(_outputs.Move, Is.Zero);
        }

        [Test]
        public void Run_NoPartPresent_WaitsForThePartThenGrips()
        {
            var missing = _ready;
            missing.ArePartsPresent = false;
            Run(missing, cycles: 100);
            Assert.That((_outputs.Move, _outputs.ClosesGrippers), Is.EqualTo((Task.Approach - 1, false)));

            var arrived = _ready;
            arrived.AreClampsOpen = arrived.IsBeltAtStation = true;
            Run(arrived, cycles: 4);

            Assert.That(_outputs.ClosesGrippers, Is.True);
        }

        [Test]
        public void Run_GripperHasNotClosed_DoesNotLift()
        {
            var closing = _ready;
            closing.AreGrippersClosed = false;

            Run(closing, cycles: 100);

            Assert.That((_outputs.Move, _outputs.ClosesGrippers), Is.EqualTo((Task.Approach, true)));
            Run(_ready, cycles: 1);
            Assert.That(_outputs.Move, Is.EqualTo(Task.Grip + 1));
        }

        [Test]
        public void Run_FixtureOccupied_DoesNotLower()
        {
            var occupied = _ready;
            occupied.AreFixturesFree = false;

            Run(occupied, cycles: 100);

            Assert.That((_outputs.Move, _outputs.ClosesGrippers), Is.EqualTo((Task.Lower - 1, true)));
        }

        [Test]
        public void Run_PartsAwayFromTheGrippers_OpensClampsThenRunsTheBeltForOneStation()
        {
            var missing = _ready;
            missing.ArePartsPresent = false;

            Run(missing, cycles: 2);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((true, false)));
            missing.AreClampsOpen = true;
            Run(missing, cycles: 1);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((true, true)));
            missing.IsBeltAtStation = true;
            Run(missing, cycles: 1);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((false, false)));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Run_GrippersInTheWay_DoesNotRunTheBelt(bool isAtFixture)
        {
            Run(_ready, cycles: 1 + (isAtFixture ? Task.Release : Task.Approach));
            var missing = new CellInputs { AreClampsOpen = true };

            Run(missing, cycles: 100);

            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((false, false)));
        }

        void Run(in CellInputs inputs, int cycles)
        {
            for (var i = 0; i < cycles; i++) _outputs = _program.Run(inputs);
        }
    }
}
