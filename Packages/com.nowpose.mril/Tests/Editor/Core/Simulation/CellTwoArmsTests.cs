using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests that two robots at one conveyor work independently of each other.</summary>
    [TestFixture("youbot")]
    [TestFixture("ur5")]
    public class CellTwoArmsTests
    {
        const int First = 0, Second = 1;

        readonly RobotModel _robot;
        readonly PickAndPlaceMotion _motion;
        CellWork _work;

        public CellTwoArmsTests(string robot)
        {
            _robot = UrdfFiles.Robot(robot);
            _motion = new PickAndPlaceMotion(_robot);
        }

        [SetUp]
        public void Start() => _work = new CellWork(_robot, _motion, 2);

        // A time after which the robots do not wait for the belt, s.
        double Running => 5 * _work.CycleSeconds;

        [Test]
        public void Robots_Undisturbed_WorkWithoutWaitingAndOutOfPhase()
        {
            var grips = GripTimes(Running, 600);

            foreach (var times in grips)
            {
                Assert.That(times, Has.Count.GreaterThan(55));
                Assert.That(times.Zip(times.Skip(1), (a, b) => b - a), Is.All.EqualTo(_work.CycleSeconds).Within(0.0015));
            }
            var phase = (grips[Second][0] - grips[First][0]) / _work.CycleSeconds;
            Assert.That(phase - Math.Floor(phase), Is.InRange(0.3, 0.7), "of a cycle");
        }

        // A UR5 waits with its open gripper at the pick place.
        [Category("Study")]
        [Test]
        public void Belt_WholeRun_MovesOnlyWhileNoGripperIsAtIt()
        {
            var running = 0;
            for (var t = 0.0; t < 100; t += 0.01)
            {
                var state = _work.StateAt(t);
                if (!state.IsBeltRunning) continue;
                running++;
                for (var i = 0; i < 2; i++)
                {
                    var (robot, grasp) = (_work.Robots[i], state.GraspOf(i, t));
                    var waits = _motion.Task.Approach > 1 && !state.ArmOf(i).ClosesGripper;
                    Assert.That(grasp.DistanceTo(robot.Placed), Is.GreaterThan(CellWork.Size), $"robot {i + 1} at the fixture, {t} s");
                    Assert.That(waits || grasp.DistanceTo(robot.Taken) > CellWork.Size, Is.True, $"robot {i + 1} at the pick place, {t} s");
                }
            }
            Assert.That(running, Is.GreaterThan(1000));
        }

        [Test]
        public void Signals_EachRobot_AreThoseOfItsOwnGripperAndLightBarrier()
        {
            var values = new double[_work.Signals.Count];
            var (closed, present) = (IndicesOf(robot => robot.GripperClosed), IndicesOf(robot => robot.PartPresent));
            int grippersDiffer = 0, barriersDiffer = 0;
            for (var state = _work.StateAt(0); state != null; state = _work.Next(state, 60))
            {
                _work.SignalsAt(TimeOf(state), values);
                var places = Enumerable.Range(0, _work.Names.Count).Select(state.PlaceOf).ToArray();
                for (var i = 0; i < 2; i++)
                {
                    var isHolding = places.Any(place => place.Holder == Holder.Gripper && place.Robot == i);
                    Assert.That(values[closed[i]], Is.EqualTo(isHolding ? 1 : 0), $"gripper {i + 1} in cycle {state.Cycle}");
                    if (isHolding && state.Cycle == state.ArmOf(i).Start && state.ArmOf(i).Move == _motion.Task.Carry)
                        Assert.That(values[present[i]], Is.Zero, $"light barrier {i + 1} in cycle {state.Cycle}");
                }
                if (values[closed[First]] != values[closed[Second]]) grippersDiffer++;
                if (values[present[First]] != values[present[Second]]) barriersDiffer++;
            }
            Assert.That(grippersDiffer, Is.Positive);
            Assert.That(barriersDiffer, Is.Positive);

            int[] IndicesOf(Func<WorkRobot, string> nameOf) => _work.Robots.Select(robot => _work.Signals.ToList().IndexOf(nameOf(robot))).ToArray();
        }

        [Test]
        public void Workpieces_RemovedFromOneRobot_OtherRobotContinues([Values(First, Second)] int delayed)
        {
            RunUntilStart(delayed, _motion.Task.Leave);
            MoveToTheBeltOf(1 - delayed);

            var grips = GripTimes(Now, Now + 6 * _work.CycleSeconds);

            Assert.That(grips[delayed][0] - Now, Is.GreaterThan(0.8 * _work.CycleSeconds), "s; the workpieces are far away");
            AssertContinues(grips[1 - delayed], Now);
        }

        [Category("Study")]
        [Test]
        public void Workpiece_RemovedUnderTheOpenGripper_OtherRobotContinues([Values(First, Second)] int delayed)
        {
            RunUntilStart(delayed, _motion.Task.Approach);
            var state = _work.StateAt(Now);
            var waiting = Enumerable.Range(0, _work.Names.Count).Single(i =>
                state.PlaceOf(i) is var place && place.Holder == Holder.Belt && place.Robot == 1 - delayed && place.Station >= CellLayout.Stations);
            _work.Plant.Put(waiting, new WorkpiecePlace(Holder.Belt, 1 - delayed, 1.5));

            var grips = GripTimes(Now, Now + 6 * _work.CycleSeconds);

            Assert.That(grips[delayed][0] - Now, Is.GreaterThan(_work.CycleSeconds), "s; the gripper has closed on nothing");
            AssertContinues(grips[1 - delayed], Now);
        }

        [Category("Study")]
        [Test]
        public void Fixture_OccupiedByHand_OtherRobotContinues([Values(First, Second)] int delayed)
        {
            RunUntilStart(delayed, _motion.Task.Carry);
            Now += 0.9 * _motion.SecondsOf(_motion.Task.Carry);
            var state = _work.StateAt(Now);
            var other = Enumerable.Range(0, _work.Names.Count).First(i => state.PlaceOf(i).Holder == Holder.Belt && state.StationOf(i, Now) < 2.5);
            _work.Plant.Put(other, new WorkpiecePlace(Holder.Fixture, delayed));
            var begin = Now;

            RunUntilStart(delayed, _motion.Task.Lower);

            Assert.That(Now - begin, Is.GreaterThan(1), "s; the belt frees the fixture first");
            AssertContinues(GripTimes(begin, begin + 6 * _work.CycleSeconds)[1 - delayed], begin);
        }

        double Now { get; set; }

        static double TimeOf(CellState state) => state.Cycle * CellState.CycleSeconds;

        // Continues until a robot starts a move.
        void RunUntilStart(int robot, int move)
        {
            int before;
            Now = Math.Max(Now, Running);
            var end = Now + 60;
            do
            {
                before = _work.StateAt(Now).ArmOf(robot).Move;
                Now += CellState.CycleSeconds;
                Assert.That(Now, Is.LessThan(end), "the move has not started within 60 s");
            }
            while (before == move || _work.StateAt(Now).ArmOf(robot).Move != move);
        }

        // Puts the waiting workpieces of the other robot on free places of the belt that leads to a robot.
        void MoveToTheBeltOf(int robot)
        {
            var state = _work.StateAt(Now);
            var belt = 1 - robot;
            var all = Enumerable.Range(0, _work.Names.Count).ToArray();
            var used = all.Where(i => state.PlaceOf(i).Robot == belt).Select(i => state.StationOf(i, Now)).ToList();
            foreach (var i in all.Where(i => state.PlaceOf(i).Holder == Holder.Belt && state.PlaceOf(i).Robot == robot))
            {
                var station = 2.5;
                while (used.Any(each => Math.Abs(each - station) < _work.Robots[belt].Belt.QueueDistance)) station -= 0.01;
                _work.Plant.Put(i, new WorkpiecePlace(Holder.Belt, belt, station));
                used.Add(station);
            }
        }

        void AssertContinues(List<double> grips, double begin)
        {
            var intervals = grips.Zip(grips.Skip(1), (a, b) => b - a).Append(grips[0] - begin).ToArray();
            Assert.That(intervals, Is.All.LessThan(1.5 * _work.CycleSeconds), "s");
            Assert.That(grips, Has.Count.GreaterThanOrEqualTo(4));
        }

        // Returns the times at which each robot takes a workpiece, s.
        List<double>[] GripTimes(double start, double end)
        {
            var grips = new[] { new List<double>(), new List<double>() };
            var before = _work.StateAt(start);
            for (var state = _work.Next(before, end); state != null; (before, state) = (state, _work.Next(state, end)))
                for (var i = 0; i < _work.Names.Count; i++)
                    if (state.PlaceOf(i).Holder == Holder.Gripper && before.PlaceOf(i).Holder != Holder.Gripper)
                        grips[state.PlaceOf(i).Robot].Add(TimeOf(state));
            return grips;
        }
    }
}
