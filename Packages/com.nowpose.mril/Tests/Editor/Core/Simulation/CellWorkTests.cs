using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Protocol.Cell;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    [TestFixture("youbot.urdf", 1)]
    [TestFixture("ur5.urdf", 1)]
    [TestFixture("youbot.urdf", 2)]
    public class CellWorkTests
    {
        readonly RobotModel _robot;
        readonly PickAndPlaceMotion _motion;
        readonly CellWork _work;

        public CellWorkTests(string urdf, int robots)
        {
            _robot = UrdfReader.Read(UrdfFiles.Text(urdf), urdf);
            _motion = new PickAndPlaceMotion(_robot);
            _work = new CellWork(_robot, _motion, robots);
        }

        double Period => _work.Names.Count * _work.CycleSeconds;
        double GripSeconds => StartOf(_motion.Task.Grip);
        double ReleaseSeconds => StartOf(_motion.Task.Release);

        [Test]
        public void CycleSeconds_Undisturbed_ExceedsThatOfTheMovesByLessThanACyclePerMove() =>
            Assert.That(_work.CycleSeconds - _motion.CycleSeconds, Is.InRange(0, 0.001 * _motion.MoveCount));

        [Test]
        public void At_Undisturbed_FollowsTheMovesWithoutWaiting()
        {
            double[] expected = new double[_motion.JointNames.Count], joints = new double[expected.Length];
            for (var cycle = 0; cycle < 3; cycle++)
                for (var move = 0; move < _motion.MoveCount; move++)
                    for (var t = 0.0; t < _motion.SecondsOf(move); t += 0.05)
                    {
                        _motion.At(move, t, expected);
                        _work.At(cycle * _work.CycleSeconds + StartOf(move) + t, joints);
                        Assert.That(joints, Is.EqualTo(expected).Within(1e-9), $"{t} s after the start of move {move} of cycle {cycle}");
                    }
        }

        [Test]
        public void StateAt_TimesInAnyOrder_EqualsTheStateOfTimesInOrder()
        {
            var other = new CellWork(_robot, _motion, _work.Robots.Count);
            var random = new Random(3);
            var times = Enumerable.Range(0, 300).Select(_ => 2 * Period * random.NextDouble()).ToArray();
            var inOrder = times.OrderBy(t => t).ToDictionary(t => t, t => Summary(other, t));

            foreach (var t in times) Assert.That(Summary(_work, t), Is.EqualTo(inOrder[t]), t + " s");
        }

        [Test]
        public void Workpieces_WholePeriod_MoveContinuously()
        {
            const double step = 0.002, maxSpeed = 6;
            for (var body = 0; body < _work.Names.Count; body++)
                for (var t = 0.0; t < 1.2 * Period; t += step)
                {
                    RigidTransform a = _work.WorldOf(body, t), b = _work.WorldOf(body, t + step);
                    Assert.That(Distance(a, b), Is.LessThan(maxSpeed * step), _work.Names[body] + " at " + t + " s");
                    Assert.That(UnitQuaternion.AngleBetween(UnitQuaternion.Of(a), UnitQuaternion.Of(b)), Is.LessThan(maxSpeed * step));
                }
        }

        [Test]
        public void Workpieces_WhenAGripperClosesOrOpens_StayWhereTheyAre()
        {
            var strokes = 0;
            for (var (before, state) = (_work.StateAt(0), _work.StateAt(0)); state != null; (before, state) = (state, _work.Next(state, Period)))
            {
                if (state.ClosesGrippers == before.ClosesGrippers) continue;
                var time = state.Cycle * CellState.CycleSeconds;
                for (var body = 0; body < _work.Names.Count; body++)
                    Assert.That(Distance(before.WorldOf(body, time), state.WorldOf(body, time)), Is.LessThan(1e-9), _work.Names[body] + " at " + time + " s");
                strokes++;
            }
            Assert.That(strokes, Is.GreaterThanOrEqualTo(4));
        }

        [Test]
        public void PoseOf_EachParent_IsConsistentWithTheWorldPose()
        {
            var seen = new HashSet<string>();
            for (var body = 0; body < _work.Names.Count; body++)
                for (var t = 0.0; t < Period; t += 0.05)
                {
                    var pose = _work.PoseOf(body, t, out var parent);
                    seen.Add(parent);
                    var robot = _work.Robots.FirstOrDefault(each => each.Tool == parent || each.Fixture == parent);
                    var known = robot == null ? _work.ConveyorPose : robot.Fixture == parent ? robot.FixturePose : robot.Base * ToolAt(t);
                    Assert.That(Distance(known * pose, _work.WorldOf(body, t)), Is.LessThan(1e-9));
                }
            Assert.That(seen, Is.EquivalentTo(_work.Robots.SelectMany(robot => new[] { robot.Tool, robot.Fixture }).Append(CellWork.Conveyor)));
        }

        [Test]
        public void Grippers_EachCycle_HoldTheWorkpiecesInTurn()
        {
            for (var cycle = 0; cycle < 2 * _work.Names.Count; cycle++)
            {
                var begin = cycle * _work.CycleSeconds;
                var inTurn = _work.Robots.Select((_, robot) => (cycle + _work.Names.Count - 3 * robot) % _work.Names.Count);
                Assert.That(HeldAt(begin + GripSeconds - 0.001), Is.Empty);
                Assert.That(HeldAt(begin + GripSeconds), Is.EquivalentTo(inTurn));
                Assert.That(HeldAt(begin + ReleaseSeconds - 0.001), Is.EquivalentTo(inTurn));
                Assert.That(HeldAt(begin + ReleaseSeconds), Is.Empty);
            }
        }

        [Test]
        public void StateAt_OlderThanTheKeptTime_IsTheOldestKeptState()
        {
            var work = new CellWork(_robot, _motion, _work.Robots.Count, keptSeconds: 60);
            var (early, kept) = (Summary(work, 9), Summary(work, 950));

            work.StateAt(1000);

            Assert.That(Summary(work, 950), Is.EqualTo(kept));
            Assert.That(Summary(work, 9), Is.Not.EqualTo(early));
            Assert.That(work.StateAt(9).Cycle, Is.InRange(1000_000 - 2 * 60_000 - 20_000, 1000_000 - 60_000), "ms; the list is shortened by halves");
        }

        [Test]
        public void Robots_InOneCell_StandApartAndHaveNamespaces()
        {
            if (_work.Robots.Count == 1)
            {
                Assert.That(_work.Robots[0].Namespace, Is.Empty);
                return;
            }
            Assert.That(_work.Robots.Select(robot => robot.Namespace), Is.EqualTo(new[] { "arm1", "arm2" }));
            Assert.That(Distance(_work.Robots[0].Base, _work.Robots[1].Base), Is.GreaterThan(0.5));
            Assert.That(_work.Robots[1].Tool, Is.EqualTo("arm2/" + _robot.ToolLink.Name));
        }

        [Test]
        public void Belt_WhileAWorkpieceIsPickedUpOrPutDown_IsAtRest()
        {
            foreach (var at in new[] { GripSeconds, ReleaseSeconds })
                for (var body = 0; body < _work.Names.Count; body++)
                    for (var t = at - 0.05; t < at + 0.05; t += 0.01)
                        if (HeldAt(t + _work.CycleSeconds).All(held => held != body))
                            Assert.That(Distance(
                                _work.WorldOf(body, _work.CycleSeconds + t), _work.WorldOf(body, _work.CycleSeconds + t + 0.001)), Is.LessThan(1e-7));
        }

        [Test]
        public void SignalsAt_WholePeriod_MatchGrippersBeltAndWorkpieces()
        {
            var values = new double[_work.Signals.Count];
            for (var t = 0.0; t < Period; t += 0.0105)
            {
                _work.SignalsAt(t, values);
                var isMoving = Enumerable.Range(0, _work.Names.Count)
                    .Any(body => !HeldAt(t).Contains(body) && Distance(_work.WorldOf(body, t - 1e-4), _work.WorldOf(body, t + 1e-4)) > 1e-7);
                Assert.That(values[0], Is.EqualTo(HeldAt(t).Any() ? 1 : 0), "gripper at " + t);
                if (isMoving) Assert.That(values[_work.Robots.Count], Is.EqualTo(1), "belt at " + t);
            }
            var robots = _work.Robots.Count;
            _work.SignalsAt(_work.CycleSeconds + GripSeconds - 0.001, values);
            Assert.That(values, Is.EqualTo(Enumerable.Repeat(0.0, robots + 1).Concat(Enumerable.Repeat(1.0, robots))),
                "the workpieces wait for the grippers");
            _work.SignalsAt(_work.CycleSeconds + GripSeconds + 0.001, values);
            Assert.That(values, Is.EqualTo(Enumerable.Repeat(1.0, robots).Concat(Enumerable.Repeat(0.0, robots + 1))));
        }

        [Test]
        public void ChangesUntil_CalledEvery50Ms_StampsChangesToTheMillisecond()
        {
            var start = ControlTime.FromSeconds(100);
            var messages = new WorkMessages(_work);
            var closed = new List<(double At, double Value)>();
            for (var i = 1; i * 0.05 < 2 * _work.CycleSeconds; i++)
                foreach (var message in messages.ChangesUntil(start + Lengths.Ms(50 * i), 0.05 * i))
                    for (var k = 0; k < message.Count; k++)
                        if (message[k].Name == _work.Robots[0].GripperClosed) closed.Add((ClockTicks.Seconds(message.Stamp - start), message[k].Value));

            Assert.That(closed.Select(change => change.Value), Is.EqualTo(new[] { 0.0, 1, 0, 1, 0 }));
            Assert.That(closed[1].At, Is.EqualTo(GripSeconds).Within(1e-6));
            Assert.That(closed[2].At, Is.EqualTo(ReleaseSeconds).Within(1e-6));
        }

        IEnumerable<int> HeldAt(double t)
        {
            for (var body = 0; body < _work.Names.Count; body++)
            {
                _work.PoseOf(body, t, out var parent);
                if (_work.Robots.Any(robot => robot.Tool == parent)) yield return body;
            }
        }

        // Returns the time in the cycle at which an undisturbed move starts: each move starts in a control cycle.
        double StartOf(int move) => 0.001 * Enumerable.Range(0, move).Sum(i => Math.Ceiling(1000 * _motion.SecondsOf(i) - 1e-6));

        static string Summary(CellWork work, double t)
        {
            var poses = Enumerable.Range(0, work.Names.Count).Select(i => (Pose: work.PoseOf(i, t, out var parent), Parent: parent));
            return work.StateAt(t).Cycle + " " + string.Join(" ", poses.Select(each => each.Parent + each.Pose.X + each.Pose.Y));
        }

        RigidTransform ToolAt(double t)
        {
            var joints = new double[_robot.MovingJoints.Count];
            _work.At(t, joints);
            var poses = new RigidTransform[_robot.Links.Count];
            new ForwardKinematics(_robot).Compute(joints, poses);
            return poses[_robot.IndexOfLink(_robot.ToolLink.Name)];
        }

        static double Distance(in RigidTransform a, in RigidTransform b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;
    }
}
