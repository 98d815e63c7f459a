using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Cli.SessionFiles;

/// <summary>The first line of a session file: the settings of the session.</summary>
/// <param name="Robot">Name of the robot.</param>
/// <param name="RobotJoints">Number of joints of this robot, whose positions frames have; 0 if the robot has not been described.</param>
/// <param name="Joints">The moving joints of this robot, then those of further robots with their namespaces, for example arm1/joint_1.</param>
/// <param name="Prediction">Prediction settings of the session.</param>
sealed record SessionHeader(string Robot, int RobotJoints, IReadOnlyList<SessionHeader.Joint> Joints, PredictionSettings Prediction)
{
    /// <param name="Unit">Unit of the position: rad or m.</param>
    public readonly record struct Joint(string Name, string Unit, JointLimits Limits)
    {
        /// <inheritdoc cref="PredictionSettings.Bounded"/>
        public JointLimits BoundedBy(PredictionSettings prediction) => prediction.Bounded(Limits, Unit == "rad");
    }
}
