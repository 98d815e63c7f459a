using System;
using YamlDotNet.Core.Events;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>Creates, finds and copies YAML nodes in Unity's layout.</summary>
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

    public static YamlNode Find(YamlMappingNode mapping, string name)
    {
        return mapping.Children.TryGetValue(new YamlScalarNode(name), out var value) ? value : null;
    }

    /// <summary>Creates a deep copy.</summary>
    public static YamlNode Copy(YamlNode node)
    {
        switch (node)
        {
            case YamlScalarNode scalar:
                return Text(scalar.Value);
            case YamlSequenceNode sequence:
                var list = new YamlSequenceNode { Style = sequence.Style };
                foreach (var item in sequence.Children) list.Add(Copy(item));
                return list;
            case YamlMappingNode mapping:
                return Copy(mapping);
            default:
                throw new ArgumentException("unsupported kind of node: " + node.NodeType, nameof(node));
        }
    }

    /// <inheritdoc cref="Copy(YamlNode)"/>
    public static YamlMappingNode Copy(YamlMappingNode mapping)
    {
        var copy = new YamlMappingNode { Style = mapping.Style };
        foreach (var entry in mapping.Children) copy.Add(Copy(entry.Key), Copy(entry.Value));
        return copy;
    }

    static YamlMappingNode Fill(YamlMappingNode mapping, (string Name, YamlNode Value)[] entries)
    {
        foreach (var (name, value) in entries) mapping.Add(name, value);
        return mapping;
    }
}
