using System.Collections.Immutable;
using Nowpose.Gateway.Recording;
using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Gateway.Hub;

/// <summary>The descriptions of all robots, and their links by their cell-wide names. Thread-safe.</summary>
/// <remarks>The links of a new description are found in the background, and are unknown until then.</remarks>
sealed class RobotLinks
{
    readonly Lock _lock = new();
    volatile ImmutableSortedDictionary<string, DescribedRobot> _described =
        ImmutableSortedDictionary.Create<string, DescribedRobot>(StringComparer.Ordinal);
    // The root link of each robot, and its links with the joints that decide whether their poses are current.
    readonly Dictionary<string, (IReadOnlyDictionary<string, string[]> Links, string Root)> _robots = [];

    /// <summary>Completes when the links of all descriptions passed so far are known.</summary>
    internal Task Read { get; private set; } = Task.CompletedTask;

    /// <summary>The described robots by their namespaces, also those whose links are not known yet. Replaced as a whole.</summary>
    public ImmutableSortedDictionary<string, DescribedRobot> Described => _described;

    /// <summary>Raised with the namespace of a robot and its new description, after its links are known. Called without a lock.</summary>
    public event Action<string, DescribedRobot> Changed;

    /// <summary>Raised with the namespace of a robot that the hub has removed, with its description. Called under the hub's lock.</summary>
    public event Action<string> Removed;

    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="described">The description, which has been parsed.</param>
    public void Describe(string robot, DescribedRobot described)
    {
        lock (_lock)
        {
            if (_described.GetValueOrDefault(robot)?.Urdf == described.Urdf) return;
            _described = _described.SetItem(robot, described);
            Read = Task.WhenAll(Read, Task.Run(() => Add(robot, described)));
        }
    }

    public void Remove(string robot)
    {
        lock (_lock)
        {
            _described = _described.Remove(robot);
            _robots.Remove(robot);
        }

        Removed?.Invoke(robot);
    }

    /// <summary>Gets the root link of the robot to which a link belongs; null for a frame that is not a robot link.</summary>
    public string RootOf(string link) => Find(link).Root;

    /// <summary>
    /// Gets the joints that decide whether the pose of a robot's link is current, by their cell-wide names; empty for a frame that is not a robot link.
    /// </summary>
    public IReadOnlyList<string> JointsOf(string link) => Find(link).Joints;

    (string Root, IReadOnlyList<string> Joints) Find(string link)
    {
        lock (_lock)
        {
            foreach (var (links, root) in _robots.Values)
                if (links.TryGetValue(link, out var joints)) return (root, joints);
            return (null, []);
        }
    }

    void Add(string robot, DescribedRobot described)
    {
        var model = described.Model;
        lock (_lock)
        {
            if (_described.GetValueOrDefault(robot) != described) return;
            if (model == null) _robots.Remove(robot);
            else _robots[robot] = (LinksOf(robot, model), RobotTopic.Qualified(robot, model.Root.Name));
        }

        Changed?.Invoke(robot, described);
    }

    static Dictionary<string, string[]> LinksOf(string robot, RobotModel model) => Enumerable.Range(0, model.Links.Count).ToDictionary(
        link => RobotTopic.Qualified(robot, model.Links[link].Name),
        link => Array.ConvertAll(ToolJoints.OfLink(link, model), joint => RobotTopic.Qualified(robot, model.MovingJoints[joint].Name)));
}
