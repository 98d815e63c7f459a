using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Options;
using Nowpose.Kinematics;

namespace Nowpose.Gateway.Plants;

/// <summary>Loads robot models: an included robot by its name, or another robot by the path of its URDF.</summary>
public static class RobotFiles
{
    static readonly string MaxNamespace = new('a', ProtocolLimits.NamespaceLength);

    static readonly string[] Included = ["youbot", "ur5", "ur3e", "ur5e", "ur10e", "ur16e"];

    /// <summary>The names of the included robots, for option help and messages.</summary>
    public static string Names { get; } = string.Join(", ", Included);

    /// <summary>Whether an included robot has this name.</summary>
    public static bool IsIncluded(string name) => Included.Contains(name);

    /// <summary>Loads a robot model.</summary>
    /// <param name="nameOrPath">Name of an included robot, such as "ur5e", or path of a .urdf file.</param>
    /// <exception cref="InputException">The file does not exist or cannot be read, or its URDF is invalid.</exception>
    public static RobotModel Load(string nameOrPath) => UrdfReader.Read(LoadText(nameOrPath), nameOrPath);

    /// <summary>Loads a robot model whose description is sent to headsets.</summary>
    /// <param name="urdf">The text of the URDF.</param>
    /// <exception cref="InputException">The file does not exist or cannot be read, or its URDF is invalid, or too long for a message.</exception>
    /// <inheritdoc cref="Load(string)" path="/param"/>
    public static RobotModel Load(string nameOrPath, out string urdf)
    {
        urdf = LoadText(nameOrPath);
        var message = HubMessage.Description(urdf, MaxNamespace, source: null, receivedAt: 0);
        if (message.IsTooLong) throw new InputException(PlantMessages.LongDescription(nameOrPath, message.Utf8(RosTimeForm.Sec).Length));
        return UrdfReader.Read(urdf, nameOrPath);
    }

    /// <summary>Reads the text of a URDF, as sent to headsets, without checking it.</summary>
    /// <inheritdoc cref="Load(string)"/>
    public static string LoadText(string nameOrPath)
    {
        if (IsIncluded(nameOrPath))
            return File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "Robots", nameOrPath + ".urdf"));
        if (string.IsNullOrWhiteSpace(nameOrPath)) throw new InputException(PlantMessages.NoRobot(Allowed));
        if (Directory.Exists(nameOrPath)) throw new InputException(PlantMessages.IsAFolder(nameOrPath, Allowed));
        return FileFault.Report(
            () => File.ReadAllText(nameOrPath),
            e => FileFault.IsMissing(e) ? PathMessages.NotFound(nameOrPath, Allowed) : PathMessages.NotRead(nameOrPath, e));
    }

    static string Allowed => PlantMessages.Robots(Names);
}
