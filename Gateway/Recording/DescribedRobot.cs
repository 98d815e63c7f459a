using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Recording;

/// <summary>The robot that a source described. Any thread.</summary>
sealed class DescribedRobot(string urdf)
{
    public static readonly DescribedRobot None = new(null);

    readonly Lazy<RobotModel> _model = new(() => ModelOf(urdf));

    /// <summary>Null where none was described.</summary>
    public string Urdf => urdf;

    /// <summary>Null where there is none; read at the first call, which takes its time: not under a lock.</summary>
    public RobotModel Model => _model.Value;

    // A description that no headset could use is none here either.
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
