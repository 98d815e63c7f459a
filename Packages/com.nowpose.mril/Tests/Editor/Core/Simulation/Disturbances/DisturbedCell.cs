using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Protocol.Cell;
using Nowpose.Tests.Core.Kinematics;

namespace Nowpose.Tests.Core.Simulation.Disturbances
{
    /// <summary>
    /// True poses of a robot, of a cart that moves, and of a part that lies on the floor, on the cart or in the gripper. A fixture
    /// stands on the floor, and a tag is on the cart.
    /// </summary>
    sealed class DisturbedCell
    {
        /// <summary>Names of the objects: the cart and the part are tracked, the fixture and the tag stationary.</summary>
        public const string Cart = "cart", Part = "part", Fixture = "fixture", Tag = "tag";

        /// <summary>Name of the robot's tool for <see cref="World"/>.</summary>
        public const string Gripper = "tool";

        /// <summary>Interval after which another carrier takes the part, in s.</summary>
        const double CarrySeconds = 3.5;

        /// <summary>Step in which speeds are measured, in s.</summary>
        const double SpeedStep = 0.02;

        static readonly string[] Carriers = { FrameParents.World, null, Cart, null };

        readonly PickAndPlaceMotion _motion;
        readonly ForwardKinematics _kinematics;
        readonly RigidTransform[] _links;
        readonly double[] _joints;
        readonly int _tool, _firstCarrier;
        readonly List<RigidTransform> _carried = new List<RigidTransform> { Pose(0.2, 0.1, 0.05, 0.3) };

        public DisturbedCell(int seed)
        {
            Robot = UrdfFiles.Robot("youbot");
            _motion = new PickAndPlaceMotion(Robot);
            JointNames = _motion.JointNames.ToArray();
            _kinematics = new ForwardKinematics(Robot);
            (_links, _joints) = (new RigidTransform[Robot.Links.Count], new double[Robot.MovingJoints.Count]);
            (_tool, _firstCarrier) = (Robot.IndexOfLink(Robot.ToolLink.Name), seed);
        }

        public RobotModel Robot { get; }

        public string[] JointNames { get; }

        public static RigidTransform FixturePose { get; } = Pose(1, 0, 0, 0.5);

        /// <summary>Pose of the tag on the cart.</summary>
        public static RigidTransform TagPose { get; } = Pose(0, 0.2, 0, 0);

        /// <summary>Returns the position of each joint.</summary>
        public double[] Joints(double time)
        {
            _motion.At(time, _joints);
            return (double[])_joints.Clone();
        }

        public RigidTransform Tool(double time)
        {
            _motion.At(time, _joints);
            _kinematics.Compute(_joints, _links);
            return _links[_tool];
        }

        /// <summary>Returns the pose of the part on its carrier.</summary>
        public RigidTransform PartOnCarrier(double time, out string carrier)
        {
            var change = (int)(time / CarrySeconds);
            carrier = CarrierAfter(change);
            return PartAfter(change);
        }

        /// <summary>Returns the pose of an object in the world.</summary>
        public RigidTransform World(string name, double time)
        {
            switch (name)
            {
                case Cart: return Pose(0.5 * Math.Sin(0.9 * time), 0.3 * Math.Cos(0.7 * time), 0.1, 0.8 * time);
                case Part: return PartOnCarrier(time, out var carrier) is var pose ? World(carrier, time) * pose : default;
                case Fixture: return FixturePose;
                case Tag: return World(Cart, time) * TagPose;
                default: return name == FrameParents.World ? RigidTransform.Identity : Tool(time);
            }
        }

        /// <summary>
        /// Returns how far an object may have moved within a time, at the maximum speed of the time before: for the part, on any carrier, because a
        /// change of the carrier arrives late.
        /// </summary>
        public double Reach(string name, double time, double seconds) =>
            name == Part ? Math.Max(Reach(Cart, Part, time, seconds), Reach(Gripper, Part, time, seconds)) : Reach(name, name, time, seconds);

        double Reach(string carrier, string name, double time, double seconds)
        {
            var onCarrier = World(carrier, time).Inverse * World(name, time);
            var max = 0.0;
            for (var t = time - seconds; t < time; t += SpeedStep)
                max = Math.Max(max, Distance(World(carrier, t) * onCarrier, World(carrier, t + SpeedStep) * onCarrier));
            return max / SpeedStep * seconds;
        }

        public static double Distance(in RigidTransform a, in RigidTransform b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;

        static RigidTransform Pose(double x, double y, double z, double yaw) => UnitQuaternion.Exp(new Vector3D(0, 0, yaw)).At(x, y, z);

        string CarrierAfter(int change) => Carriers[(change + _firstCarrier) % Carriers.Length] ?? Robot.ToolLink.Name;

        // The part stays where it is when another carrier takes it.
        RigidTransform PartAfter(int change)
        {
            for (var i = _carried.Count; i <= change; i++)
            {
                var time = i * CarrySeconds;
                _carried.Add(World(CarrierAfter(i), time).Inverse * World(CarrierAfter(i - 1), time) * _carried[i - 1]);
            }
            return _carried[change];
        }
    }
}
