using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests that the robots of a disturbed cell wait for their inputs, and continue.</summary>
    [TestFixture("youbot", 1)]
    [TestFixture("ur5", 1)]
    [TestFixture("youbot", 2)]
    public class CellDisturbanceTests
    {
        readonly RobotModel _robot;
        readonly PickAndPlaceMotion _motion;
        readonly int _robots;
        CellWork _work;

        public CellDisturbanceTests(string robot, int robots)
        {
            _robot = UrdfFiles.Robot(robot);
            _motion = new PickAndPlaceMotion(_robot);
            _robots = robots;
        }

        [SetUp]
        public void Start() => _work = new CellWork(_robot, _motion, _robots);

        // Times in the undisturbed second cycle, s.
        double Approach => _work.CycleSeconds + _motion.StartOf(_motion.Task.Approach);
        double Grip => _work.CycleSeconds + _motion.StartOf(_motion.Task.Grip);
        double Lower => _work.CycleSeconds + _motion.StartOf(_motion.Task.Lower);

        [Test]
        public void Belt_Blocked_RobotsWaitBeforeThePickAndThenContinue()
        {
            RunUntil(_work.CycleSeconds - 0.1);
            Assert.That(IsBeltRunning(), Is.True);
            _work.Plant.IsBeltBlocked = true;

            RunUntil(Grip + 20);

            Assert.That(IsBeltRunning(), Is.False);
            Assert.That(HeldCount(), Is.Zero);
            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Approach)).Within(1e-9));
            _work.Plant.IsBeltBlocked = false;
            var next = TimeOf(state => state.ClosesGrippers);
            Assert.That(next - (Grip + 20), Is.InRange(Grip - Approach, Grip - Approach + 5), "s after the end of the blockage");
            Assert.That(_work.StateAt(next).IsBeltRunning, Is.False);
            Assert.That(HeldCount(), Is.EqualTo(_robots));
            AssertGripsOncePerCycle(next);
        }

        [Test]
        public void Workpiece_RemovedFromThePickPlace_RobotsWaitForTheNextWorkpiece()
        {
            RunUntil(Approach - 0.004);
            var waiting = WaitingForFirstRobot();
            Assert.That(_work.StateAt(Now).PartsPresent, Is.EqualTo((1 << _robots) - 1));
            _work.Plant.Put(waiting, new WorkpiecePlace(Holder.Belt, _robots - 1, 0.5));

            RunUntil(Approach + 0.5);

            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Approach)).Within(1e-9), "the robots wait");
            Assert.That(IsBeltRunning(), Is.True, "the belt brings the next workpiece");
            var next = TimeOf(state => state.ClosesGrippers);
            Assert.That(next, Is.GreaterThan(Grip + 0.1));
            Assert.That(_work.StateAt(next).PlaceOf(waiting).Holder, Is.EqualTo(Holder.Belt));
            Assert.That(HeldCount(), Is.EqualTo(_robots));
            AssertGripsOncePerCycle(next);
        }

        [Test]
        public void Workpiece_RemovedUnderTheOpenGripper_GripperStaysOpenUntilOneIsPresent()
        {
            RunUntil(Grip - 0.1);
            var waiting = WaitingForFirstRobot();
            _work.Plant.Put(waiting, new WorkpiecePlace(Holder.Belt, _robots - 1, 2.5));

            RunUntil(Grip + 10);

            Assert.That(_work.StateAt(Now).ClosesGrippers, Is.False);
            Assert.That(HeldCount(), Is.Zero);
            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Grip)).Within(1e-9));
            Assert.That(IsBeltRunning(), Is.False, "the gripper is in the way of the belt");
            _work.Plant.Put(waiting, new WorkpiecePlace(Holder.Belt, _robots - 1, CellLayout.Stations));
            AssertGripsOncePerCycle(Grip + 10.001);
        }

        [Test]
        public void Fixture_Occupied_RobotsKeepTheirWorkpiecesUntilItIsFree()
        {
            RunUntil(Grip + 0.5);
            var other = Enumerable.Range(0, _work.Names.Count).First(i => _work.StateAt(Now).PlaceOf(i).Holder == Holder.Belt);
            var place = _work.StateAt(Now).PlaceOf(other);
            _work.Plant.Put(other, new WorkpiecePlace(Holder.Fixture, 0));

            RunUntil(Lower + 10);

            Assert.That(HeldCount(), Is.EqualTo(_robots));
            Assert.That(Joints(), Is.EqualTo(Waypoint(_motion.Task.Lower)).Within(1e-9));
            _work.Plant.Put(other, place);
            var released = TimeOf(state => !state.ClosesGrippers);
            Assert.That(released - (Lower + 10), Is.EqualTo(_motion.StartOf(_motion.Task.Release) - _motion.StartOf(_motion.Task.Lower)).Within(0.005));
        }

        [Test]
        public void Gripper_ClosesAwayFromTheWorkpieces_HoldsNothing()
        {
            var plant = new CellPlant(new CellLayout(_robot, _motion, _robots));
            plant.Sense(0);

            plant.Follow(new CellOutputs { Move = plant.State.Move, ClosesGrippers = true });

            Assert.That(plant.State.ClosesGrippers, Is.True);
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
                Assert.That(HeldCount(), Is.EqualTo(_robots), $"in cycle {cycle} after the disturbance");
                RunUntil(Now + _motion.StartOf(_motion.Task.Release) - _motion.StartOf(_motion.Task.Grip) + 0.02);
                Assert.That(HeldCount(), Is.Zero);
            }
        }

        int HeldCount() => Enumerable.Range(0, _work.Names.Count).Count(i => _work.StateAt(Now).PlaceOf(i).Holder == Holder.Gripper);

        bool IsBeltRunning() => _work.StateAt(Now).IsBeltRunning;

        int WaitingForFirstRobot() => Enumerable.Range(0, _work.Names.Count).Single(i =>
            _work.StateAt(Now).PlaceOf(i) is var place && place.Robot == _robots - 1 && place.Station >= CellLayout.Stations);

        double[] Joints()
        {
            var joints = new double[_motion.JointNames.Count];
            _work.At(Now, joints);
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
