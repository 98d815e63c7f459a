using System;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>The links of a displayed robot, to which frames can be attached.</summary>
    interface IRobotLinks
    {
        /// <summary>The robot's namespace; empty if the robot has none.</summary>
        string Namespace { get; }

        RobotModel Robot { get; }

        /// <summary>Returns whether the pose of a link is valid for the display time, apart from the range of the render time.</summary>
        bool IsCurrentAt(int link);

        /// <summary>Poses of all links relative to the robot's root link, right-handed, in m, in the order of the robot's links.</summary>
        ReadOnlySpan<RigidTransform> Poses { get; }

        /// <summary>Poses of the newest samples, which a display without compensation shows; otherwise like <see cref="Poses"/>.</summary>
        ReadOnlySpan<RigidTransform> HeldPoses { get; }

        /// <summary>Returns the pose of a link relative to the robot's root link at a time other than the displayed one.</summary>
        RigidTransform PoseAt(int link, ControlTime at, out PoseOrigin origin);
    }
}
