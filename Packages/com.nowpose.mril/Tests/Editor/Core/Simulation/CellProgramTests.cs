using Nowpose.Motion;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests the control program of one and of two robots with given inputs, without a plant.</summary>
    public class CellProgramTests
    {
        const int Moves = 9;

        static readonly TaskMoves Task = new TaskMoves(approach: 1, grip: 2, lower: 5, release: 6);

        static readonly ArmInputs Ready = new ArmInputs
        {
            IsPartPresent = true, IsFixtureFree = true, IsAtRest = true, IsGripperOpen = true, IsGripperClosed = true,
        };

        static readonly ArmInputs Moving = new ArmInputs { IsPartPresent = true, IsFixtureFree = true };

        CellProgram _program;
        CellOutputs _outputs;

        [SetUp]
        public void Start() => _program = new CellProgram(Task, Moves, 1);

        [Test]
        public void Run_AllInputsSet_StartsEachMoveInTurnAndSwitchesTheGripper()
        {
            for (var cycle = 0; cycle < 3 * Moves; cycle++)
            {
                Run(1, Ready);
                var step = cycle % Moves;
                if (step != Task.Grip && step != Task.Release) Assert.That(_outputs.Arms[0].Move, Is.EqualTo(step));
                Assert.That(_outputs.Arms[0].ClosesGripper, Is.EqualTo(step >= Task.Grip && step < Task.Release));
                Assert.That(_outputs.RunsBelt, Is.False, "the part is present");
            }
        }

        [Test]
        public void Run_RobotMoves_StartsNoMove()
        {
            Run(1, Ready);

            Run(100, Moving);

            Assert.That(_outputs.Arms[0].Move, Is.Zero);
        }

        [Test]
        public void Run_NoPartPresent_WaitsForThePartThenGrips()
        {
            Run(100, Missing);
            Assert.That((_outputs.Arms[0].Move, _outputs.Arms[0].ClosesGripper), Is.EqualTo((Task.Approach - 1, false)));

            RunBelt(4, Ready);

            Assert.That(_outputs.Arms[0].ClosesGripper, Is.True);
        }

        [Test]
        public void Run_PartRemovedDuringTheApproach_GripperClosesAndTheBeltRunsAfterwards()
        {
            Run(1 + Task.Approach, Ready);

            Run(1, Missing);
            Assert.That((_outputs.Arms[0].ClosesGripper, _outputs.OpensClamps), Is.EqualTo((true, false)));
            Run(Moves, Missing);

            Assert.That((_outputs.Arms[0].Move, _outputs.OpensClamps), Is.EqualTo((Task.Approach - 1, true)));
        }

        [Test]
        public void Run_GripperHasNotClosed_DoesNotLift()
        {
            var closing = Ready;
            closing.IsGripperClosed = false;

            Run(100, closing);

            Assert.That((_outputs.Arms[0].Move, _outputs.Arms[0].ClosesGripper), Is.EqualTo((Task.Approach, true)));
            Run(1, Ready);
            Assert.That(_outputs.Arms[0].Move, Is.EqualTo(Task.Grip + 1));
        }

        [Test]
        public void Run_FixtureOccupied_DoesNotLowerBeforeTheBeltHasFreedIt()
        {
            var occupied = Ready;
            occupied.IsFixtureFree = false;

            Run(100, occupied);

            Assert.That((_outputs.Arms[0].Move, _outputs.Arms[0].ClosesGripper), Is.EqualTo((Task.Lower - 1, true)));
            Assert.That(_outputs.OpensClamps, Is.True);
            RunBelt(1, Ready);
            Assert.That((_outputs.Arms[0].Move, _outputs.RunsBelt), Is.EqualTo((Task.Lower - 1, true)));
            RunBelt(1, Ready);
            Assert.That((_outputs.Arms[0].Move, _outputs.RunsBelt), Is.EqualTo((Task.Lower, false)));
        }

        [Test]
        public void Run_PartAwayFromTheGripper_OpensClampsThenRunsTheBeltForOneStation()
        {
            Run(2, Missing);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((true, false)));
            RunBelt(1, Missing);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((true, true)));
            RunBelt(1, Missing);
            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((false, false)));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Run_GripperInTheWay_DoesNotRunTheBelt(bool isAtFixture)
        {
            Run(1 + (isAtFixture ? Task.Release : Task.Approach), Ready);

            RunBelt(100, default(ArmInputs));

            Assert.That((_outputs.OpensClamps, _outputs.RunsBelt), Is.EqualTo((false, false)));
        }

        [Test]
        public void Run_OneOfTwoRobotsWaits_TheOtherContinues()
        {
            _program = new CellProgram(Task, Moves, 2);
            var closing = Ready;
            closing.IsGripperClosed = false;

            Run(1 + Task.Grip, closing, Ready);
            Run(3 * Moves, closing, Ready);

            Assert.That((_outputs.Arms[0].Move, _outputs.Arms[0].ClosesGripper), Is.EqualTo((Task.Approach, true)));
            Assert.That(_outputs.Arms[1].ClosesGripper, Is.True, "the second robot is at its fourth grip");
            Run(1, closing, Ready);
            Assert.That(_outputs.Arms[1].Move, Is.EqualTo(Task.Grip + 1));
        }

        [TestCase(0, true)] // to a workpiece
        [TestCase(1, true)] // first move at the pick place
        [TestCase(3, true)] // last move at the pick place
        [TestCase(4, false)] // to the fixture
        [TestCase(5, true)] // first move at the fixture
        [TestCase(7, true)] // last move at the fixture
        [TestCase(8, false)] // back
        public void Run_SecondRobotNeedsAPart_BeltStartsUnlessTheFirstRobotBlocksIt(int move, bool isBlocked)
        {
            _program = new CellProgram(Task, Moves, 2);
            var absent = new ArmInputs { IsPartPresent = true, IsFixtureFree = true };
            Run(1 + move, Ready, absent);

            Run(100, Moving, default);

            Assert.That(_outputs.OpensClamps, Is.EqualTo(!isBlocked));
        }

        [TestCase(1)]
        [TestCase(5)]
        public void Run_BeltRunsForTheSecondRobot_FirstRobotWaitsBeforeIt(int move)
        {
            _program = new CellProgram(Task, Moves, 2);
            Run(move, Ready, Moving);
            Run(1, new ArmInputs { IsFixtureFree = true }, default);
            Assert.That(_outputs.OpensClamps, Is.True);

            Run(100, Ready, default);

            Assert.That(_outputs.Arms[0].Move, Is.EqualTo(move - 1));
            RunBelt(2, Ready, Moving);
            Assert.That((_outputs.Arms[0].Move, _outputs.OpensClamps), Is.EqualTo((move, false)));
        }

        static ArmInputs Missing
        {
            get
            {
                var missing = Ready;
                missing.IsPartPresent = false;
                return missing;
            }
        }

        void Run(int cycles, params ArmInputs[] arms) => Run(cycles, new CellInputs { Arms = arms });

        // The clamps have opened, and the belt has moved by one station.
        void RunBelt(int cycles, params ArmInputs[] arms) =>
            Run(cycles, new CellInputs { Arms = arms, AreClampsOpen = true, IsBeltAtStation = true });

        void Run(int cycles, in CellInputs inputs)
        {
            for (var i = 0; i < cycles; i++) _outputs = _program.Run(inputs);
        }
    }
}
