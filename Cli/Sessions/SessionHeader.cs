using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.Sessions;

/// <summary>The first line of a session file: the settings of the session.</summary>
/// <param name="Robot">Name of the robot.</param>
/// <param name="Joints">The moving joints, in the order of the frames' positions.</param>
/// <param name="Prediction">The session's prediction settings.</param>
sealed record SessionHeader(string Robot, IReadOnlyList<SessionHeader.Joint> Joints, PredictionSettings Prediction)
{
    /// <param name="Unit">rad or m.</param>
    public readonly record struct Joint(string Name, string Unit, JointLimits Limits);
}
