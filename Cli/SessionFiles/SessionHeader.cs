using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.SessionFiles;

/// <summary>The first line of a session file: the settings of the session.</summary>
/// <param name="Robot">Name of the robot.</param>
/// <param name="Joints">
/// The moving joints of the robot, in the order of the positions in frames. In a gateway's file, the joints of robots in namespaces follow, for example
/// arm1/joint_1.
/// </param>
/// <param name="IsRobotDescribed">Whether the joints of the robot without a namespace are known.</param>
/// <param name="Prediction">Prediction settings of the session.</param>
sealed record SessionHeader(string Robot, IReadOnlyList<SessionHeader.Joint> Joints, PredictionSettings Prediction, bool IsRobotDescribed)
{
    /// <param name="Unit">Unit of the position: rad or m.</param>
    public readonly record struct Joint(string Name, string Unit, JointLimits Limits);
}
