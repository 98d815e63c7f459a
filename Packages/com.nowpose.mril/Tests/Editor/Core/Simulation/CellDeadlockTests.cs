using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Disturbs a cell at random times, and tests that its robots work again afterwards.</summary>
    [TestFixture("youbot", 1)]
    [TestFixture("ur5", 1)]
    [TestFixture("youbot", 2)]
    [TestFixture("ur5", 2)]
    public class CellDeadlockTests
    {
        const int Disturbances = 20, RecoveryCycles = 4, WorkingCycles = 3;

        readonly RobotModel _robot;
        readonly PickAndPlaceMotion _motion;
        readonly int _robots;
        CellWork _work;
        Random _random;
        double _now;

        public CellDeadlockTests(string robot, int robots)
        {
            _robot = UrdfFiles.Robot(robot);
            _motion = new PickAndPlaceMotion(_robot);
            _robots = robots;
        }

        [TestCase(1)]
        [TestCase(2, Category = "Study")]
        [TestCase(3, Category = "Study")]
        [TestCase(4, Category = "Study")]
        [TestCase(5, Category = "Study")]
        public void Program_DisturbedAtRandomTimes_AllRobotsWorkAgain(int seed)
        {
            _work = new CellWork(_robot, _motion, _robots);
            _random = new Random(seed);
            _now = 0;
            for (var i = 0; i < Disturbances; i++)
            {
                _now += Math.Pow(_random.NextDouble(), 2) * _work.CycleSeconds;
                _work.StateAt(_now);
                if (_random.Next(4) == 0) _work.Plant.IsBeltBlocked = _random.Next(2) == 0;
                else PutByHand(_random.Next(_work.Names.Count));
            }
            _work.Plant.IsBeltBlocked = false;

            var grips = GripCounts(_now + RecoveryCycles * _work.CycleSeconds, WorkingCycles * _work.CycleSeconds);

            Assert.That(grips, Is.All.GreaterThanOrEqualTo(WorkingCycles - 1), $"grips of each robot after the disturbances until {_now} s");
        }

        // Puts a workpiece on a belt or a fixture, if the place is free. A belt has a stop at its end, which workpieces often touch.
        void PutByHand(int workpiece)
        {
            var state = _work.Plant.State;
            var robot = _random.Next(_robots);
            var isFixture = _random.Next(4) == 0;
            var station = isFixture ? 0 : CellLayout.Stations * Math.Min(1, 1.2 * _random.NextDouble());
            var task = _motion.Task;
            var belt = _work.Robots[robot].Belt;
            var near = belt.QueueDistance;
            bool IsGripperAt(int arm, int from, int to) => state.ArmOf(arm).Move >= from && state.ArmOf(arm).Move < to;
            if (station < near && IsGripperAt(robot, task.Lower, task.Leave)) return;
            if (station > CellLayout.Stations - near && IsGripperAt((robot + 1) % _robots, task.Approach, task.Carry)) return;
            for (var i = 0; i < _work.Names.Count; i++)
            {
                var place = state.PlaceOf(i);
                var isHere = place.Robot == robot && place.Holder != Holder.Gripper && Math.Abs(state.StationOf(i, _now) - station) < near;
                if (i != workpiece && isHere) return;
            }
            // The belt may have been blocked during a step.
            var moved = belt.StepAt(state.BeltSecondsAt(_now));
            _work.Plant.Put(workpiece, new WorkpiecePlace(isFixture ? Holder.Fixture : Holder.Belt, robot, isFixture ? 0 : station - moved));
        }

        // Returns how often each robot takes a workpiece.
        int[] GripCounts(double start, double seconds)
        {
            var grips = new int[_robots];
            var state = _work.StateAt(start);
            for (var next = _work.Next(state, start + seconds); next != null; (state, next) = (next, _work.Next(next, start + seconds)))
                for (var i = 0; i < _work.Names.Count; i++)
                    if (next.PlaceOf(i).Holder == Holder.Gripper && state.PlaceOf(i).Holder != Holder.Gripper) grips[next.PlaceOf(i).Robot]++;
            return grips;
        }
    }
}
