using System;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Protocol;

namespace Nowpose.Simulation.Work
{
    /// <summary>One robot of a <see cref="CellWork"/>, with its place in the cell, its fixture and the belt behind it.</summary>
    sealed class WorkRobot
    {
        readonly RobotModel _robot;

        /// <param name="index">Index of the robot in the cell, from 0.</param>
        /// <param name="count">Number of robots. A single robot has no namespace and stands at the origin; a second robot faces the first.</param>
        /// <param name="distance">Distance between the bases of two robots, as a multiple of the distance from a base to its grip position.</param>
        public WorkRobot(RobotModel robot, PickAndPlaceMotion motion, int index, int count, double distance)
        {
            _robot = robot;
            var suffix = count == 1 ? "" : "_" + (index + 1);
            Namespace = count == 1 ? "" : "arm" + (index + 1);
            Tool = RobotTopic.Qualified(Namespace, robot.ToolLink.Name);
            Root = RobotTopic.Qualified(Namespace, robot.Root.Name);
            Fixture = "fixture" + suffix;
            GripperClosed = "gripper_closed" + suffix;
            PartPresent = "part_present" + suffix;
            var (taken, released) = (ToolAt(motion, motion.Task.Grip), ToolAt(motion, motion.Task.Release));
            var upright = RigidTransform.FromXyzRpy(taken.X, taken.Y, taken.Z, 0, 0, Math.Atan2(taken.Y, taken.X));
            var reach = Math.Sqrt(taken.X * taken.X + taken.Y * taken.Y);
            Base = RigidTransform.FromXyzRpy(index * distance * reach, 0, 0, 0, 0, index * Math.PI);
            InTool = taken.Inverse * upright;
            Taken = Base * upright;
            Placed = Base * released * InTool;
            FixturePose = RigidTransform.FromXyzRpy(Placed.X, Placed.Y, Placed.Z - CellWork.Size / 2, 0, 0, 0);
        }

        public string Namespace { get; }

        /// <summary>Frame name of the tool's link, with the robot's namespace.</summary>
        public string Tool { get; }

        /// <summary>Frame name of the root link, with the robot's namespace.</summary>
        public string Root { get; }

        /// <summary>Name of the stationary frame of the fixture, whose origin is the middle of the fixture's upper side.</summary>
        public string Fixture { get; }

        /// <summary>Name of the signal that is 1 from the start of closing the gripper until the start of opening it.</summary>
        public string GripperClosed { get; }

        /// <summary>Name of the signal that is 1 while a workpiece waits for this robot.</summary>
        public string PartPresent { get; }

        /// <summary>Pose of the root link in the world.</summary>
        public RigidTransform Base { get; }

        /// <summary>Pose of a gripped workpiece in the link of the tool.</summary>
        public RigidTransform InTool { get; }

        /// <summary>World pose of a workpiece when it is picked up.</summary>
        public RigidTransform Taken { get; }

        /// <summary>World pose of a workpiece when it is put down.</summary>
        public RigidTransform Placed { get; }

        /// <summary>Pose of <see cref="Fixture"/> in the world.</summary>
        public RigidTransform FixturePose { get; }

        /// <summary>The belt from this robot's fixture to the next robot.</summary>
        public Belt Belt { get; set; }

        /// <summary>Returns the pose of the tool's link in the robot's base frame.</summary>
        /// <param name="joints">Positions of the moving joints, rad or m.</param>
        public RigidTransform ToolOf(double[] joints)
        {
            var poses = new RigidTransform[_robot.Links.Count];
            new ForwardKinematics(_robot).Compute(joints, poses);
            return poses[_robot.IndexOfLink(_robot.ToolLink.Name)];
        }

        // Returns the pose of the tool's link at the beginning of a move.
        RigidTransform ToolAt(PickAndPlaceMotion motion, int move)
        {
            var joints = new double[_robot.MovingJoints.Count];
            motion.At(move, 0, joints);
            return ToolOf(joints);
        }
    }
}
