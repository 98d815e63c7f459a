using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Protocol.Cell;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    [TestFixture("youbot.urdf")]
    [TestFixture("ur5.urdf")]
    public class CellWorkTests
    {
        readonly RobotModel _robot;
        readonly IGrippingMotion _motion;
        readonly CellWork _work;

        public CellWorkTests(string urdf)
        {
            _robot = UrdfReader.Read(UrdfFiles.Text(urdf), urdf);
            _motion = new PickAndPlaceMotion(_robot);
            _work = new CellWork(_robot, _motion);
        }

        double Period => CellWork.Names.Count * _motion.CycleSeconds;

        [Test]
        public void Workpieces_AllTheTime_NeverJump()
        {
            const double step = 0.002, maxSpeed = 6;
            for (var body = 0; body < CellWork.Names.Count; body++)
                for (var t = 0.0; t < 1.2 * Period; t += step)
                {
                    RigidTransform a = _work.WorldOf(body, t), b = _work.WorldOf(body, t + step);
                    Assert.That(Distance(a, b), Is.LessThan(maxSpeed * step), CellWork.Names[body] + " at " + t + " s");
                    Assert.That(UnitQuaternion.AngleBetween(UnitQuaternion.Of(a), UnitQuaternion.Of(b)), Is.LessThan(maxSpeed * step));
                }
        }

        [Test]
        public void PoseOf_EachParent_GivesThePoseInTheWorld()
        {
            var seen = new HashSet<string>();
            for (var body = 0; body < CellWork.Names.Count; body++)
                for (var t = 0.0; t < Period; t += 0.05)
                {
                    var pose = _work.PoseOf(body, t, out var parent);
                    seen.Add(parent);
                    var known = parent == CellWork.Conveyor ? _work.ConveyorPose : parent == CellWork.Fixture ? _work.FixturePose : ToolAt(t);
                    Assert.That(Distance(known * pose, _work.WorldOf(body, t)), Is.LessThan(1e-9));
                }
            Assert.That(seen, Is.EquivalentTo(new[] { CellWork.Conveyor, CellWork.Fixture, _robot.ToolLink.Name }));
        }

        [Test]
        public void Gripper_EachCycle_HoldsOneWorkpieceAfterTheOther()
        {
            for (var cycle = 0; cycle < 2 * CellWork.Names.Count; cycle++)
            {
                var begin = cycle * _motion.CycleSeconds;
                Assert.That(HeldAt(begin + _motion.GripSeconds - 0.001), Is.Empty);
                Assert.That(HeldAt(begin + _motion.GripSeconds + 0.001), Is.EqualTo(new[] { cycle % CellWork.Names.Count }));
                Assert.That(HeldAt(begin + _motion.ReleaseSeconds - 0.001), Is.EqualTo(new[] { cycle % CellWork.Names.Count }));
                Assert.That(HeldAt(begin + _motion.ReleaseSeconds + 0.001), Is.Empty);
            }
        }

        [Test]
        public void Belt_WhileAWorkpieceIsTakenOrPutDown_IsAtRest()
        {
            foreach (var at in new[] { _motion.GripSeconds, _motion.ReleaseSeconds })
                for (var body = 0; body < CellWork.Names.Count; body++)
                    for (var t = at - 0.05; t < at + 0.05; t += 0.01)
                        if (HeldAt(t + _motion.CycleSeconds).All(held => held != body))
                            Assert.That(Distance(
                                _work.WorldOf(body, _motion.CycleSeconds + t), _work.WorldOf(body, _motion.CycleSeconds + t + 0.001)), Is.LessThan(1e-7));
        }

        [Test]
        public void Signals_AllTheTime_AreThoseOfTheObjects()
        {
            var values = new double[CellWork.Signals.Count];
            for (var t = 0.0; t < Period; t += 0.0105)
            {
                _work.SignalsAt(t, values);
                var isMoving = Enumerable.Range(0, CellWork.Names.Count)
                    .Any(body => !HeldAt(t).Contains(body) && Distance(_work.WorldOf(body, t - 1e-4), _work.WorldOf(body, t + 1e-4)) > 1e-7);
                Assert.That(values[0], Is.EqualTo(HeldAt(t).Any() ? 1 : 0), "gripper at " + t);
                if (isMoving) Assert.That(values[1], Is.EqualTo(1), "belt at " + t);
            }
            _work.SignalsAt(_motion.CycleSeconds + _motion.GripSeconds - 0.001, values);
            Assert.That(values, Is.EqualTo(new double[] { 0, 0, 1 }), "a workpiece waits for the gripper");
            _work.SignalsAt(_motion.CycleSeconds + _motion.GripSeconds + 0.001, values);
            Assert.That(values, Is.EqualTo(new double[] { 1, 0, 0 }));
        }

        [Test]
        public void Changes_CoarseSampling_HaveTheStampsOfTheirCycles()
        {
            var start = ControlTime.FromSeconds(100);
            var messages = new WorkMessages(_work);
            var closed = new List<(double At, double Value)>();
            for (var i = 1; i * 0.05 < 2 * _motion.CycleSeconds; i++)
                foreach (var message in messages.ChangesUntil(start + Lengths.Ms(50 * i), 0.05 * i))
                    for (var k = 0; k < message.Count; k++)
                        if (message[k].Name == CellWork.GripperClosed) closed.Add((ClockTicks.Seconds(message.Stamp - start), message[k].Value));

            Assert.That(closed.Select(change => change.Value), Is.EqualTo(new[] { 0.0, 1, 0, 1, 0 }));
            Assert.That(closed[1].At - _motion.GripSeconds, Is.InRange(0, 0.0011));
            Assert.That(closed[2].At - _motion.ReleaseSeconds, Is.InRange(0, 0.0011));
        }

        IEnumerable<int> HeldAt(double t)
        {
            for (var body = 0; body < CellWork.Names.Count; body++)
            {
                _work.PoseOf(body, t, out var parent);
                if (parent == _robot.ToolLink.Name) yield return body;
            }
        }

        RigidTransform ToolAt(double t)
        {
            var joints = new double[_robot.MovingJoints.Count];
            _motion.At(t, joints);
            var poses = new RigidTransform[_robot.Links.Count];
            new ForwardKinematics(_robot).Compute(joints, poses);
            return poses[_robot.IndexOfLink(_robot.ToolLink.Name)];
        }

        static double Distance(in RigidTransform a, in RigidTransform b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;
    }
}
