using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Recording;

/// <summary>A robot description and the model parsed from it. Thread-safe.</summary>
sealed class DescribedRobot(string urdf)
{
    readonly Lazy<RobotModel> _model = new(() => ModelOf(urdf));

    /// <summary>The text of the description; null if there is none.</summary>
    public string Urdf => urdf;

    /// <summary>The model; null without a valid description. The first call is slow, so do not make it under a lock.</summary>
    public RobotModel Model => _model.Value;

    // Returns null for an invalid description, which headsets cannot use either.
    static RobotModel ModelOf(string urdf)
    {
        try
        {
            return urdf == null ? null : UrdfReader.Read(urdf, RosTopics.RobotDescription);
        }
        catch (InputException)
        {
            return null;
        }
    }
}
