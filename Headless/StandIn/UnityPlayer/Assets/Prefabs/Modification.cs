using Nowpose.UnityPlayer.Assets.Yaml;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>One value, a scalar or a reference, in which an object of a prefab instance differs from the prefab.</summary>
readonly struct Modification
{
    public Modification(string path, string value, AssetReference reference)
    {
        Path = path;
        Value = value;
        Reference = reference;
    }

    public string Path { get; }
    public string Value { get; }
    public AssetReference Reference { get; }

    public YamlMappingNode Write(AssetReference target)
    {
        return Nodes.Lines(
            ("target", target.Write()),
            ("propertyPath", Nodes.Text(Path)),
            ("value", Nodes.Text(Value)),
            ("objectReference", Reference.Write()));
    }
}
