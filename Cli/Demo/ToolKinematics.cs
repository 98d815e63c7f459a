using Nowpose.Kinematics;

namespace Nowpose.Cli.Demo;

/// <summary>Computes the position of the tool from joint positions. Used for scoring.</summary>
sealed class ToolKinematics(RobotModel robot)
{
    readonly ForwardKinematics _kinematics = new(robot);
    readonly RigidTransform[] _poses = new RigidTransform[robot.Links.Count];
    readonly double[] _joints = new double[robot.MovingJoints.Count];
    readonly int _tool = robot.IndexOfLink(robot.ToolLink.Name);

    public ToolPosition At(ReadOnlySpan<double> positions) => ToolPosition.Of(PoseAt(positions));

    public RigidTransform PoseAt(ReadOnlySpan<double> positions)
    {
        _kinematics.Compute(positions, _poses);
        return _poses[_tool];
    }

    /// <summary>Gets the position of the real robot's tool at a control time.</summary>
    public ToolPosition TrueAt(IDemoTruth truth, ControlTime t)
    {
        truth.JointsAt(t, _joints);
        return At(_joints);
    }
}
