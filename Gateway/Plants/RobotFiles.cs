using Nowpose.Gateway.Messages;
using Nowpose.Kinematics;

namespace Nowpose.Gateway.Plants;

/// <summary>Loads robots by the name of an included one, or by the path of a URDF.</summary>
public static class RobotFiles
{
    static readonly string[] Included = ["youbot", "ur5", "ur3e", "ur5e", "ur10e", "ur16e"];

    /// <summary>The names of the included robots, for option help and messages.</summary>
    public static string Names { get; } = string.Join(", ", Included);

    /// <summary>Whether the name is that of an included robot.</summary>
    public static bool IsIncluded(string name) => Included.Contains(name);

    /// <param name="nameOrPath">"youbot", "ur5e" or another included robot, or the path of a .urdf file.</param>
    /// <exception cref="InputException">The robot does not exist, or its URDF cannot be read or computed.</exception>
    public static RobotModel Load(string nameOrPath) => Load(nameOrPath, out _);

    /// <param name="urdf">The robot's text, as it is sent to a headset.</param>
    /// <inheritdoc cref="Load(string)"/>
    public static RobotModel Load(string nameOrPath, out string urdf)
    {
        urdf = LoadText(nameOrPath);
        return UrdfReader.Read(urdf, nameOrPath);
    }

    /// <summary>Reads the URDF text that is sent to a headset, without checks.</summary>
    /// <inheritdoc cref="Load(string)"/>
    public static string LoadText(string nameOrPath)
    {
        if (IsIncluded(nameOrPath))
            return File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "Robots", nameOrPath + ".urdf"));
        if (string.IsNullOrWhiteSpace(nameOrPath)) throw new InputException(PlantMessages.NoRobot(Allowed));
        if (Directory.Exists(nameOrPath)) throw new InputException($"{nameOrPath}: is a folder; {Allowed}");
        try
        {
            return File.ReadAllText(nameOrPath);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new InputException($"{nameOrPath}: file not found; {Allowed}", e);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new InputException($"{nameOrPath}: cannot be read: {e.Message.ReplaceLineEndings(" ")}", e);
        }
    }

    static string Allowed => PlantMessages.Robots(Names);
}
