using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Recording;

/// <summary>The robot description from a source, with its model. Thread-safe.</summary>
sealed class DescribedRobot(string urdf)
{
    public static readonly DescribedRobot None = new(null);

    readonly Lazy<RobotModel> _model = new(() => ModelOf(urdf));

    /// <summary>Null if no robot was described.</summary>
    public string Urdf => urdf;

    /// <summary>The model, or null if there is none. Computed slowly at the first call, so do not call this under a lock.</summary>
    public RobotModel Model => _model.Value;

    // Null for a description that a headset could not use.
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
