using YamlDotNet.Core.Events;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>Creates and finds YAML nodes in Unity's layout.</summary>
static class Nodes
{
    public static YamlScalarNode Text(string value) => new YamlScalarNode(value);

    public static YamlScalarNode Number(long value) => Text(Numbers.Write(value));

    /// <summary>Creates a mapping that is written in braces on one line.</summary>
    public static YamlMappingNode Braces(params (string Name, YamlNode Value)[] entries) =>
        Fill(new YamlMappingNode { Style = MappingStyle.Flow }, entries);

    /// <summary>Creates a mapping that is written with one line per entry.</summary>
    public static YamlMappingNode Lines(params (string Name, YamlNode Value)[] entries) =>
        Fill(new YamlMappingNode { Style = MappingStyle.Block }, entries);

    public static YamlSequenceNode List() => new YamlSequenceNode { Style = SequenceStyle.Block };

    public static YamlNode Find(YamlMappingNode mapping, string name) =>
        mapping.Children.TryGetValue(new YamlScalarNode(name), out var value) ? value : null;

    static YamlMappingNode Fill(YamlMappingNode mapping, (string Name, YamlNode Value)[] entries)
    {
        foreach (var (name, value) in entries) mapping.Add(name, value);
        return mapping;
    }
}
