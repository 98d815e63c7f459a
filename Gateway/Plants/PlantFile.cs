using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

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

    /// <summary>Whether the file has objects or signals.</summary>
    public bool HasObjects { get; init; }

    /// <summary>The URDF of the robot without a namespace that the adapter publishes; null for none.</summary>
    public string Robot { get; init; }

    /// <summary>The URDFs of robots in namespaces that the adapter publishes.</summary>
    public IReadOnlyDictionary<string, string> Robots { get; init; } = new Dictionary<string, string>();

    /// <summary>Gets whether joint positions have to arrive from a gateway's plants. A cell without a robot may have objects and signals alone.</summary>
    /// <param name="robot">The URDF that the gateway itself publishes; null for none.</param>
    public static bool ExpectsJoints(IReadOnlyCollection<PlantFile> plants, string robot) => plants.Count > 0
        && (robot != null || !plants.Any(plant => plant.HasObjects)
            || plants.Any(plant => plant.Joints.Count > 0 || plant.PassesUnlisted || plant.Robot != null || plant.Robots.Count > 0));

    /// <summary>Gets the joints of a robot's arm that no plant publishes, without which headsets cannot show a current pose; those of robots in namespaces as NAMESPACE/JOINT.</summary>
    /// <param name="plants">All plants of a gateway.</param>
    /// <param name="robot">The URDF that the gateway itself publishes; null for none.</param>
    public static IReadOnlyList<string> MissingJoints(IReadOnlyCollection<PlantFile> plants, string robot)
    {
        var published = plants.SelectMany(plant => plant.Joints).ToHashSet();
        if (published.Count == 0 || plants.Any(plant => plant.PassesUnlisted)) return [];
        var own = KeyValuePair.Create("", robot ?? plants.Select(plant => plant.Robot).FirstOrDefault(urdf => urdf != null));
        return
        [
            .. from described in plants.SelectMany(plant => plant.Robots).DistinctBy(one => one.Key).Prepend(own)
               let model = new DescribedRobot(described.Value).Model
               where model != null
               let names = UnpublishedJoints.NamesOf(model).ConvertAll(name => RobotTopic.Qualified(described.Key, name))
               // A robot whose joints are all unpublished may have its source elsewhere.
               where described.Key.Length == 0 || names.Exists(published.Contains)
               from name in names
               where !published.Contains(name)
               select name,
        ];
    }
}
