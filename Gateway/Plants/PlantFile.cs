using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Plants;

/// <summary>A checked plant configuration.</summary>
/// <param name="Path">Path of the file.</param>
/// <param name="Name">Name of the plant, under which its adapter reports.</param>
/// <param name="Summary">A line for the log: the data and their source.</param>
sealed record PlantFile(string Path, string Name, string Summary)
{
    /// <summary>Names of the configured joints.</summary>
    public IReadOnlyList<string> Joints { get; init; } = [];

    /// <summary>Whether the adapter also publishes joints that the file does not list.</summary>
    public bool PassesUnlisted { get; init; }

    /// <summary>The URDF that the adapter publishes; null for none.</summary>
    public string Robot { get; init; }

    /// <summary>Gets the joints of a robot's arm that no plant publishes, without which headsets cannot show a current pose.</summary>
    /// <param name="plants">All plants of a gateway.</param>
    /// <param name="robot">The URDF that the gateway itself publishes; null for none.</param>
    public static IReadOnlyList<string> MissingJoints(IReadOnlyCollection<PlantFile> plants, string robot)
    {
        var description = new DescribedRobot(robot ?? plants.Select(plant => plant.Robot).FirstOrDefault(urdf => urdf != null)).Model;
        var published = plants.SelectMany(plant => plant.Joints).ToHashSet();
        if (description == null || published.Count == 0 || plants.Any(plant => plant.PassesUnlisted)) return [];
        return UnpublishedJoints.NamesOf(description).FindAll(name => !published.Contains(name));
    }
}
