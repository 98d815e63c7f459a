using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.Sessions;

/// <summary>The first line of a session file: the settings of the session.</summary>
/// <param name="Robot">Name of the robot.</param>
/// <param name="Joints">The moving joints, in the order of the positions in frames.</param>
/// <param name="Prediction">Prediction settings of the session.</param>
sealed record SessionHeader(string Robot, IReadOnlyList<SessionHeader.Joint> Joints, PredictionSettings Prediction)
{
    /// <param name="Unit">Unit of the position: rad or m.</param>
    public readonly record struct Joint(string Name, string Unit, JointLimits Limits);
}
