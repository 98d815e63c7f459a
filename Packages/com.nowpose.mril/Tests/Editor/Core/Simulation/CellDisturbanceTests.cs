using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests that the robot of a disturbed cell waits for its inputs, and continues.</summary>
    [TestFixture("youbot")]
    [TestFixture("ur5")]
    public class CellDisturbanceTests
    {
        readonly RobotModel _robot;
        readonly PickAndPlaceMotion _motion;
        CellWork _work;

        public CellDisturbanceTests(string robot)
        {
            _robot = UrdfFiles.Robot(robot);
            _motion = new PickAndPlaceMotion(_robot);
        }

        [SetUp]
        public void Start() => _work = new CellWork(_robot, _motion);

        // Times in the undisturbed second cycle, s.
        double Approach => _work.CycleSeconds + _motion.StartOf(_motion.Task.Approach);
        double Grip => _work.CycleSeconds + _motion.StartOf(_motion.Task.Grip);
        double Lower => _work.CycleSeconds + _motion.StartOf(_motion.Task.Lower);

        [Test]
        public void Belt_Blocked_RobotWaitsBeforeThePickAndThenContinues()
        {
            RunUntil(_work.CycleSeconds - 0.1);
            Assert.That(IsBeltRunning(), Is.True);
            _work.Plant.IsBeltBlocked = true;

            RunUntil(Grip + 20);

            Assert.That(IsBeltRunning(), Is.False);
            Assert.That(HeldCount(), Is.Zero);
            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Approach)).Within(1e-9));
            _work.Plant.IsBeltBlocked = false;
            var next = TimeOf(state => state.ArmOf(0).ClosesGripper);
            Assert.That(next - (Grip + 20), Is.InRange(Grip - Approach, Grip - Approach + 5), "s after the end of the blockage");
            Assert.That(_work.StateAt(next).IsBeltRunning, Is.False);
            Assert.That(HeldCount(), Is.EqualTo(1));
            AssertGripsOncePerCycle(next);
        }

        [Test]
        public void Workpiece_RemovedFromThePickPlace_RobotWaitsForTheNextWorkpiece()
        {
            RunUntil(Approach - 0.004);
            var waiting = Waiting();
            Assert.That(_work.StateAt(Now).PartsPresent, Is.EqualTo(1));
            _work.Plant.Put(waiting, new WorkpiecePlace(Holder.Belt, 0, 0.5));

            RunUntil(Approach + 0.5);

            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Approach)).Within(1e-9), "the robot waits");
            Assert.That(IsBeltRunning(), Is.True, "the belt brings the next workpiece");
            var next = TimeOf(state => state.ArmOf(0).ClosesGripper);
            Assert.That(next, Is.GreaterThan(Grip + 0.1));
            Assert.That(_work.StateAt(next).PlaceOf(waiting).Holder, Is.EqualTo(Holder.Belt));
            Assert.That(HeldCount(), Is.EqualTo(1));
            AssertGripsOncePerCycle(next);
        }

        [Test]
        public void Workpiece_RemovedUnderTheOpenGripper_RobotCarriesNothingAndTakesTheNextOne()
        {
            RunUntil(Grip - 0.1);
            _work.Plant.Put(Waiting(), new WorkpiecePlace(Holder.Belt, 0, 2.5));

            RunUntil(Grip + 0.1);

            Assert.That(_work.StateAt(Now).ArmOf(0).ClosesGripper, Is.True);
            Assert.That(HeldCount(), Is.Zero);
            RunUntil(Lower);
            Assert.That(IsBeltRunning(), Is.False, "the gripper is on its way to the fixture");
            AssertGripsOncePerCycle(Grip);
        }

        [Test]
        public void Fixture_OccupiedByHand_RobotKeepsItsWorkpieceUntilTheBeltHasFreedIt()
        {
            RunUntil(Grip + 0.5);
            var other = Enumerable.Range(0, _work.Names.Count).First(i => _work.StateAt(Now).PlaceOf(i).Holder == Holder.Belt);
            _work.Plant.Put(other, new WorkpiecePlace(Holder.Fixture, 0));
            _work.Plant.IsBeltBlocked = true;

            RunUntil(Lower + 10);

            Assert.That(HeldCount(), Is.EqualTo(1));
            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Lower)).Within(1e-9));
            _work.Plant.IsBeltBlocked = false;
            TimeOf(state => state.ArmOf(0).Move == _motion.Task.Lower);
            Assert.That(Now - (Lower + 10), Is.InRange(1, 4), "s; one step of the belt");
            Assert.That(IsBeltRunning(), Is.False);
            // The belt has no workpiece at one of its stations. When this station arrives, the robot waits for the next one.
            for (var cycle = 0; cycle < 3; cycle++)
            {
                TimeOf(state => !state.ArmOf(0).ClosesGripper);
                TimeOf(state => state.ArmOf(0).ClosesGripper);
            }
            AssertGripsOncePerCycle(Now);
        }

        [Test]
        public void Gripper_ClosesAwayFromTheWorkpieces_HoldsNothing()
        {
            var plant = new CellPlant(new CellLayout(_robot, _motion, 1));
            plant.Sense(0);

            plant.Follow(new CellOutputs { Arms = new[] { new ArmOutputs { Move = plant.State.ArmOf(0).Move, ClosesGripper = true } } });

            Assert.That(plant.State.ArmOf(0).ClosesGripper, Is.True);
            Assert.That(Enumerable.Range(0, _work.Names.Count).Select(i => plant.State.PlaceOf(i).Holder), Is.All.EqualTo(Holder.Belt));
        }

        double Now { get; set; }

        void RunUntil(double seconds) => _work.StateAt(Now = seconds);

        // Continues until a state has a property, and returns the time of this state.
        double TimeOf(Func<CellState, bool> isReached)
        {
            for (var end = Now + 60; Now < end; Now += 0.001)
                if (isReached(_work.StateAt(Now))) return Now;
            throw new AssertionException("the state was not reached within 60 s");
        }

        // From this grip on, the cell works as before.
        void AssertGripsOncePerCycle(double grip)
        {
            for (var cycle = 1; cycle < 6; cycle++)
            {
                RunUntil(grip + cycle * _work.CycleSeconds + 0.01);
                Assert.That(HeldCount(), Is.EqualTo(1), $"in cycle {cycle} after the disturbance");
                RunUntil(Now + _motion.StartOf(_motion.Task.Release) - _motion.StartOf(_motion.Task.Grip) + 0.02);
                Assert.That(HeldCount(), Is.Zero);
            }
        }

        int HeldCount() => Enumerable.Range(0, _work.Names.Count).Count(i => _work.StateAt(Now).PlaceOf(i).Holder == Holder.Gripper);

        bool IsBeltRunning() => _work.StateAt(Now).IsBeltRunning;

        int Waiting() => Enumerable.Range(0, _work.Names.Count).Single(i =>
            _work.StateAt(Now).PlaceOf(i).Station >= CellLayout.Stations);

        double[] Joints()
        {
            var joints = new double[_motion.JointNames.Count];
            _work.Motions[0].Motion.At(Now, joints);
            return joints;
        }

        double[] Waypoint(int waypoint)
        {
            var joints = new double[_motion.JointNames.Count];
            _motion.At(waypoint, 0, joints);
            return joints;
        }
    }
}
