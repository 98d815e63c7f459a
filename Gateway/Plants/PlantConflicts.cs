using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Plants;

/// <summary>Finds entries of several plant configurations that one gateway cannot publish together.</summary>
static class PlantConflicts
{
    /// <summary>Gets a warning for each name that two files publish, and for each limit of the cell that all files together exceed.</summary>
    /// <remarks>These are not errors, because a second source may be a standby, which the gateway accepts when the first source has ended.</remarks>
    /// <param name="plants">All plants of a gateway.</param>
    public static IEnumerable<string> Of(IReadOnlyCollection<PlantFile> plants)
    {
        (string Kind, Func<PlantFile, IEnumerable<string>> Names, int Limit)[] kinds =
        [
            (CellKinds.Joint, plant => plant.Joints, int.MaxValue),
            (CellKinds.Frame, plant => plant.Frames.Keys, ProtocolLimits.Frames),
            (CellKinds.Signal, plant => plant.Signals, ProtocolLimits.Signals),
        ];
        foreach (var (kind, names, limit) in kinds)
        {
            var owners = new Dictionary<string, string>();
            foreach (var (plant, name) in plants.SelectMany(plant => names(plant).Select(name => (plant, name))))
                if (!owners.TryAdd(name, plant.Path)) yield return DryRunMessages.PublishedTwice(plant.Path, kind, name, owners[name]);
            if (owners.Count > limit) yield return DryRunMessages.TooMany(kind + "s", owners.Count, limit);
        }

        var robots = plants.SelectMany(plant => plant.Joints.Where(name => name.Contains('/')).Select(name => name[..name.IndexOf('/')]).Concat(plant.Robots.Keys))
            .Distinct().Count();
        if (robots > ProtocolLimits.Robots) yield return DryRunMessages.TooMany("namespaces", robots, ProtocolLimits.Robots);
    }
}
