using System.Text.Json.Serialization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Plants;

/// <summary>A checked plant configuration, read from the JSON that the adapter program prints.</summary>
/// <param name="Path">Path of the file.</param>
/// <param name="Name">Name of the plant, which is also the name of its adapter in the gateway's status.</param>
/// <param name="Summary">A line for the log about the data and their source.</param>
sealed record PlantFile(string Path, string Name, string Summary)
{
    /// <summary>Names of the configured joints.</summary>
    [JsonRequired]
    public IReadOnlyList<string> Joints { get; init; } = [];

    /// <summary>Whether the adapter also publishes joints that the file does not list.</summary>
    public bool PassesUnlisted { get; init; }

    /// <summary>Whether the file configures objects or signals.</summary>
    public bool HasObjects { get; init; }

    /// <summary>The URDF that the adapter publishes for the robot without a namespace; null if it publishes none.</summary>
    public string Robot { get; init; }

    /// <summary>The URDFs that the adapter publishes for robots with a namespace, by namespace.</summary>
    public IReadOnlyDictionary<string, string> Robots { get; init; } = new Dictionary<string, string>();

    /// <summary>The entry of the file that names the description of each robot, by namespace. Messages about the description begin with it.</summary>
    public IReadOnlyDictionary<string, string> DescribedBy { get; init; } = new Dictionary<string, string>();

    /// <summary>The possible parents of each configured frame, by the name of the frame. Empty if the parent arrives with the pose.</summary>
    public IReadOnlyDictionary<string, string[]> Frames { get; init; } = new Dictionary<string, string[]>();

    /// <summary>Names of the configured signals.</summary>
    public IReadOnlyList<string> Signals { get; init; } = [];

    /// <summary>Whether the adapter offers the plant's clock, with the name of the plant.</summary>
    public bool OffersClock { get; init; } = true;

    /// <summary>The machine to which the adapter connects, if it accepts only one connection from each machine; null otherwise.</summary>
    public string SoleConnectionTo { get; init; }

    /// <summary>The environment variable with the password of this plant only; null if its password is not in such a variable.</summary>
    public string PasswordVariable { get; init; }

    /// <summary>Warnings about valid entries of the file, each with the file and the line.</summary>
    public IReadOnlyList<string> Warnings { get; init; } = [];

    /// <summary>Gets the warnings about the plants of one gateway: about the entries of each file, and about entries that do not fit together.</summary>
    /// <param name="plants">All plants of a gateway.</param>
    /// <param name="clock">The selected control clock; null for the first one that an adapter offers.</param>
    public static IEnumerable<string> WarningsOf(IReadOnlyCollection<PlantFile> plants, string clock) =>
        plants.SelectMany(plant => plant.Warnings).Concat(PlantConflicts.Of(plants)).Concat(ClockWarning(plants, clock));

    // Another client may offer the selected clock, so this is not an error.
    static IEnumerable<string> ClockWarning(IReadOnlyCollection<PlantFile> plants, string clock)
    {
        string[] offered = [.. plants.Where(plant => plant.OffersClock).Select(plant => plant.Name)];
        if (clock == null) return offered.Length > 1 ? [DryRunMessages.SeveralClocks(offered)] : [];
        return plants.Count == 0 || clock == PlantClocks.Own || offered.Contains(clock) ? [] : [DryRunMessages.ClockNotOffered(clock, offered)];
    }

    /// <summary>
    /// Whether the plants of a gateway must send joint positions. False for a cell with objects or signals but without a robot.
    /// </summary>
    /// <param name="plants">All plants of the gateway.</param>
    /// <param name="robot">The URDF that the gateway itself publishes; null if it publishes none.</param>
    public static bool ExpectsJoints(IReadOnlyCollection<PlantFile> plants, string robot) => plants.Count > 0
        && (robot != null || !plants.Any(plant => plant.HasObjects)
            || plants.Any(plant => plant.Joints.Count > 0 || plant.PassesUnlisted || plant.Robot != null || plant.Robots.Count > 0));

    /// <summary>
    /// Gets the arm joints that no plant publishes. Headsets cannot show a current pose without them. Joints of a robot with a namespace are
    /// named NAMESPACE/JOINT.
    /// </summary>
    /// <param name="plants">All plants of a gateway.</param>
    /// <param name="robot">The URDF that the gateway itself publishes; null if it publishes none.</param>
    public static IReadOnlyList<string> MissingJoints(IReadOnlyCollection<PlantFile> plants, string robot)
    {
        var published = plants.SelectMany(plant => plant.Joints).ToHashSet();
        if (published.Count == 0 || plants.Any(plant => plant.PassesUnlisted)) return [];
        return
        [
            .. from described in Described(plants, robot)
               let names = UnpublishedJoints.NamesOf(described.Model).ConvertAll(name => RobotTopic.Qualified(described.Namespace, name))
               // Skips a robot without any published joint, because another program may publish its joints.
               where described.Namespace.Length == 0 || names.Exists(published.Contains)
               from name in names
               where !published.Contains(name)
               select name,
        ];
    }

    /// <summary>
    /// Gets the parents that are not world, a frame, or a link of a described robot, each with the first frame that has this parent. Objects with
    /// such a parent have no place in the cell.
    /// </summary>
    /// <param name="plants">All plants of a gateway.</param>
    /// <param name="robot">The URDF that the gateway itself publishes; null if it publishes none.</param>
    /// <param name="stationary">The stationary frames that the gateway itself publishes; null if it publishes none.</param>
    public static IReadOnlyList<(string Parent, string Frame)> MissingParents(
        IReadOnlyCollection<PlantFile> plants, string robot, TransformsMessage stationary)
    {
        var placed = Enumerable.Range(0, stationary?.Count ?? 0).Select(i => (stationary[i].Parent, Frame: stationary[i].Child)).ToList();
        var pairs = plants.SelectMany(plant => plant.Frames)
            .SelectMany(frame => frame.Value.Select(parent => (Parent: parent, Frame: frame.Key))).Concat(placed).ToList();
        var links = Described(plants, robot).SelectMany(
            described => described.Model.Links.Select(link => RobotTopic.Qualified(described.Namespace, link.Name)));
        var known = plants.SelectMany(plant => plant.Frames.Keys).Concat(placed.Select(one => one.Frame)).Concat(links)
            .Append(FrameParents.World).ToHashSet();
        return [.. pairs.Where(pair => !known.Contains(pair.Parent)).DistinctBy(pair => pair.Parent)];
    }

    // Gets the robots with a valid description: the robot without a namespace, and one robot of each namespace.
    static IEnumerable<(string Namespace, RobotModel Model)> Described(IReadOnlyCollection<PlantFile> plants, string robot)
    {
        var own = KeyValuePair.Create("", robot ?? plants.Select(plant => plant.Robot).FirstOrDefault(urdf => urdf != null));
        return from described in plants.SelectMany(plant => plant.Robots).DistinctBy(one => one.Key).Prepend(own)
               let model = new DescribedRobot(described.Value).Model
               where model != null
               select (described.Key, model);
    }
}
