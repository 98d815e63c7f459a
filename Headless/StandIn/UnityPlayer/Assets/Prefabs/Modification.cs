using Nowpose.UnityPlayer.Assets.Yaml;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>One value, a scalar or a reference, in which an object of a prefab instance differs from the prefab.</summary>
readonly record struct Modification(string Path, string Value, AssetReference Reference)
{
    public YamlMappingNode Write(AssetReference target) => Nodes.Lines(
        ("target", target.Write()),
        ("propertyPath", Nodes.Text(Path)),
        ("value", Nodes.Text(Value)),
        ("objectReference", Reference.Write()));
}
