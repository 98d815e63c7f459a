using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
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

        [Test]
        public void StateAt_TimesInAnyOrder_EqualsTheStateOfTimesInOrder()
        {
            var other = new CellWork(_robot, _motion, _work.Robots.Count);
            var random = new Random(3);
            var times = Enumerable.Range(0, 300).Select(_ => 2 * Period * random.NextDouble()).ToArray();
            var inOrder = times.OrderBy(t => t).ToDictionary(t => t, t => Summary(other, t));

            foreach (var t in times) Assert.That(Summary(_work, t), Is.EqualTo(inOrder[t]), t + " s");
        }

        [Category("Study")]
        [Test]
        public void Workpieces_WholePeriod_MoveContinuously()
        {
            const double step = 0.002, maxSpeed = 6;
            for (var body = 0; body < _work.Names.Count; body++)
            {
                var before = _work.WorldOf(body, 0);
                for (var t = step; t < 1.2 * Period; t += step)
                {
                    var pose = _work.WorldOf(body, t);
                    var turn = UnitQuaternion.AngleBetween(UnitQuaternion.Of(before), UnitQuaternion.Of(pose));
                    if (!(Distance(before, pose) < maxSpeed * step) || !(turn < maxSpeed * step)) Assert.Fail(_work.Names[body] + " at " + t + " s");
                    before = pose;
                }
            }
        }

        [Test]
        public void Workpieces_WhenAGripperClosesOrOpens_StayWhereTheyAre()
        {
            var strokes = 0;
            for (var (before, state) = (_work.StateAt(0), _work.StateAt(0)); state != null; (before, state) = (state, _work.Next(state, Period)))
            {
                if (_work.Robots.Select((_, i) => i).All(i => state.ArmOf(i).ClosesGripper == before.ArmOf(i).ClosesGripper)) continue;
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
                    var known = robot == null ? _work.ConveyorPose : robot.Fixture == parent ? robot.FixturePose : robot.Base * ToolAt(t, robot);
                    Assert.That(Distance(known * pose, _work.WorldOf(body, t)), Is.LessThan(1e-9));
                }
            Assert.That(seen, Is.EquivalentTo(_work.Robots.SelectMany(robot => new[] { robot.Tool, robot.Fixture }).Append(CellWork.Conveyor)));
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

        static string Summary(CellWork work, double t)
        {
            var poses = Enumerable.Range(0, work.Names.Count).Select(i => (Pose: work.PoseOf(i, t, out var parent), Parent: parent));
            return work.StateAt(t).Cycle + " " + string.Join(" ", poses.Select(each => each.Parent + each.Pose.X + each.Pose.Y));
        }

        RigidTransform ToolAt(double t, WorkRobot robot)
        {
            var joints = new double[_robot.MovingJoints.Count];
            _work.Motions.Single(each => each.Namespace == robot.Namespace).Motion.At(t, joints);
            var poses = new RigidTransform[_robot.Links.Count];
            new ForwardKinematics(_robot).Compute(joints, poses);
            return poses[_robot.IndexOfLink(_robot.ToolLink.Name)];
        }

        static double Distance(in RigidTransform a, in RigidTransform b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;
    }
}
