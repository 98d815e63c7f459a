namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Finds and changes references to objects of the same file, at any depth of a value.</summary>
static class LocalReferences
{
    /// <summary>Returns a deep copy.</summary>
    public static YamlNode Copy(YamlNode node) => Map(node, fileId => fileId);

    /// <summary>
    /// Returns a deep copy in which the fileIDs of local references are mapped by <paramref name="map"/>. Other references are unchanged.
    /// </summary>
    public static YamlNode Map(YamlNode node, Func<long, long> map)
    {
        if (AssetReference.TryRead(node, out var reference))
            return (reference.Guid == null ? new AssetReference(map(reference.FileId)) : reference).Write();
        switch (node)
        {
            case YamlMappingNode mapping:
                var fields = new YamlMappingNode { Style = mapping.Style };
                foreach (var entry in mapping.Children) fields.Add(Map(entry.Key, map), Map(entry.Value, map));
                return fields;
            case YamlSequenceNode sequence:
                var list = new YamlSequenceNode { Style = sequence.Style };
                foreach (var item in sequence.Children) list.Add(Map(item, map));
                return list;
            default:
                return Nodes.Text(((YamlScalarNode)node).Value);
        }
    }

    /// <summary>Returns the fileIDs of all local references except 0, which is the empty reference.</summary>
    public static IEnumerable<long> In(YamlNode node)
    {
        if (AssetReference.TryRead(node, out var reference))
        {
            if (reference.Guid == null && reference.FileId != 0) yield return reference.FileId;
            yield break;
        }
        var children = node switch
        {
            YamlMappingNode mapping => mapping.Children.Values,
            YamlSequenceNode sequence => sequence.Children,
            _ => Array.Empty<YamlNode>() as IEnumerable<YamlNode>,
        };
        foreach (var child in children)
        {
            foreach (var id in In(child)) yield return id;
        }
    }
}
