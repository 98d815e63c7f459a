using Nowpose.Kinematics;

namespace Nowpose.Gateway.Recording;

/// <summary>A robot description and the model parsed from it. Thread-safe.</summary>
/// <param name="urdf">The text of the description; null if there is none.</param>
/// <param name="source">Name of the description in the fault.</param>
sealed class DescribedRobot(string urdf, string source = RosTopics.RobotDescription)
{
    readonly Lazy<(RobotModel Model, string Fault)> _read = new(() => Read(urdf, source));

    /// <summary>The text of the description; null if there is none.</summary>
    public string Urdf => urdf;

    /// <summary>The model; null without a valid description. The first call is slow, so do not make it under a lock.</summary>
    public RobotModel Model => _read.Value.Model;

    /// <summary>The reason why the description is invalid, so that headsets cannot use it; null if there is none. As slow as <see cref="Model"/>.</summary>
    public string Fault => _read.Value.Fault;

    static (RobotModel, string) Read(string urdf, string source)
    {
        try
        {
            return (urdf == null ? null : UrdfReader.Read(urdf, source), null);
        }
        catch (InputException invalid)
        {
            return (null, invalid.Message);
        }
    }
}
