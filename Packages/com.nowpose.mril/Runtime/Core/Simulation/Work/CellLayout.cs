using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Motion;

namespace Nowpose.Simulation.Work
{
    /// <summary>The stationary parts of a cell: places of robots, fixtures and belts, and the names of frames and signals. Immutable.</summary>
    sealed class CellLayout
    {
        /// <summary>Number of stations from a fixture to the next robot's pick place, and number of workpieces per robot.</summary>
        public const int Stations = 3;

        /// <summary>Stroke time of the fixtures' clamps, s: that of a small pneumatic cylinder.</summary>
        public const double ClampSeconds = 0.2;

        /// <summary>Distance between the bases of two robots, as a multiple of the distance from a base to its grip position.</summary>
        const double RobotDistance = 3.2;

        /// <summary>Time that control cycles may add between the end of a belt step and the next approach, s.</summary>
        const double CycleMargin = 0.01;

        /// <summary>Duration of a belt step that is always permitted, s. Robots with shorter moves wait for the belt.</summary>
        const double PermittedSeconds = 0.5;

        /// <inheritdoc cref="CellWork(RobotModel, PickAndPlaceMotion, int, double)"/>
        public CellLayout(RobotModel robot, PickAndPlaceMotion motion, int robots)
        {
            Motion = motion;
            Robots = Enumerable.Range(0, robots).Select(i => new WorkRobot(robot, motion, i, robots, RobotDistance)).ToArray();
            // The belt is fast enough that the robots do not wait for it. With several robots, it also runs while one of them carries its workpiece.
            var whileAway = motion.CycleSeconds - motion.StartOf(motion.Task.Leave) + motion.StartOf(motion.Task.Approach);
            var whileCarrying = motion.StartOf(motion.Task.Lower) - motion.StartOf(motion.Task.Carry);
            var clearSeconds = robots == 1 ? whileAway : Math.Min(whileAway, whileCarrying);
            var maxSeconds = Math.Max(PermittedSeconds, clearSeconds - ClampSeconds - CycleMargin);
            for (var i = 0; i < robots; i++)
                Robots[i].Belt = new Belt(Robots[i].Placed, Robots[Next(i)].Taken, Stations, maxSeconds, isRing: robots == 1);
            BeltStepSeconds = Robots.Max(each => each.Belt.StepSeconds);
            ConveyorPose = RigidTransform.FromXyzRpy(0, 0, Robots[0].Taken.Z - CellWork.Size / 2, 0, 0, 0);
            ToConveyor = ConveyorPose.Inverse;
            Names = Enumerable.Range(1, Stations * robots).Select(i => "workpiece_" + i).ToArray();
            Signals = Robots.Select(each => each.GripperClosed).Append(CellWork.BeltRunning).Concat(Robots.Select(each => each.PartPresent)).ToArray();
        }

        public PickAndPlaceMotion Motion { get; }
        public WorkRobot[] Robots { get; }

        /// <summary>Time that the belt needs for one station, s.</summary>
        public double BeltStepSeconds { get; }

        /// <summary>Pose of the conveyor's frame in the world.</summary>
        public RigidTransform ConveyorPose { get; }

        /// <summary>Pose of the world in the conveyor's frame.</summary>
        public RigidTransform ToConveyor { get; }

        /// <summary>Names of the workpieces' frames.</summary>
        public IReadOnlyList<string> Names { get; }

        /// <summary>Names of the signals: each gripper, the belt, the light barrier at each pick place.</summary>
        public IReadOnlyList<string> Signals { get; }

        /// <summary>Returns the index of the robot to which the belt behind a robot leads. A single robot's belt leads back to itself.</summary>
        public int Next(int robot) => (robot + 1) % Robots.Length;
    }
}
