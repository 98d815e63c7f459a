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
    /// <summary>Tests the times of moves, grips, belt and signals in an undisturbed cell with one robot.</summary>
    [TestFixture("youbot")]
    [TestFixture("ur5")]
    public class CellTimingTests
    {
        readonly PickAndPlaceMotion _motion;
        readonly CellWork _work;

        public CellTimingTests(string name)
        {
            var robot = UrdfFiles.Robot(name);
            _motion = new PickAndPlaceMotion(robot);
            _work = new CellWork(robot, _motion);
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
                        _work.Motions[0].Motion.At(cycle * _work.CycleSeconds + StartOf(move) + t, joints);
                        Assert.That(joints, Is.EqualTo(expected).Within(1e-9), $"{t} s after the start of move {move} of cycle {cycle}");
                    }
        }

        [Test]
        public void Grippers_EachCycle_HoldTheWorkpiecesInTurn()
        {
            for (var cycle = 0; cycle < 2 * _work.Names.Count; cycle++)
            {
                var begin = cycle * _work.CycleSeconds;
                var inTurn = new[] { cycle % _work.Names.Count };
                Assert.That(HeldAt(begin + GripSeconds - 0.001), Is.Empty);
                Assert.That(HeldAt(begin + GripSeconds), Is.EquivalentTo(inTurn));
                Assert.That(HeldAt(begin + ReleaseSeconds - 0.001), Is.EquivalentTo(inTurn));
                Assert.That(HeldAt(begin + ReleaseSeconds), Is.Empty);
            }
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
                if (isMoving) Assert.That(values[1], Is.EqualTo(1), "belt at " + t);
            }
            _work.SignalsAt(_work.CycleSeconds + GripSeconds - 0.001, values);
            Assert.That(values, Is.EqualTo(new[] { 0.0, 0, 1 }), "the workpiece waits for the gripper");
            _work.SignalsAt(_work.CycleSeconds + GripSeconds + 0.001, values);
            Assert.That(values, Is.EqualTo(new[] { 1.0, 0, 0 }));
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
                if (parent == _work.Robots[0].Tool) yield return body;
            }
        }

        // Returns the time in the cycle at which an undisturbed move starts: each move starts in a control cycle.
        double StartOf(int move) => 0.001 * Enumerable.Range(0, move).Sum(i => Math.Ceiling(1000 * _motion.SecondsOf(i) - 1e-6));

        static double Distance(in RigidTransform a, in RigidTransform b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;
    }
}
