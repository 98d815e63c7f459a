namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>Computes the modifications that change one object into another. This is the inverse of <see cref="PropertyPath.Set"/>.</summary>
static class Modifications
{
    /// <summary>
    /// Fields that define the hierarchy. They are not stored as modifications, because an instance has the hierarchy of its prefab, plus added
    /// children.
    /// </summary>
    static readonly HashSet<string> Structure = new HashSet<string> { "m_GameObject", "m_Component", "m_Father", "m_Children" };

    /// <summary>Returns the modifications by which an object differs from its prefab object.</summary>
    /// <exception cref="AssetException">
    /// The objects have different fields, because the prefab was written with an older version of the class.
    /// </exception>
    public static IEnumerable<Modification> Between(FileObject prefab, YamlMappingNode now) =>
        Between(Values(prefab.Fields), Values(now), "", prefab);

    static YamlMappingNode Values(YamlMappingNode fields) =>
        new YamlMappingNode(fields.Children.Where(f => !Structure.Contains(((YamlScalarNode)f.Key).Value)));

    static IEnumerable<Modification> Between(YamlNode before, YamlNode now, string path, FileObject prefab)
    {
        if (AssetReference.TryRead(before, out var old) && AssetReference.TryRead(now, out var reference))
            return old.Equals(reference) ? Array.Empty<Modification>() : One(path, "", reference);
        return (before, now) switch
        {
            (YamlScalarNode a, YamlScalarNode b) => a.Value == b.Value ? Array.Empty<Modification>() : One(path, b.Value, AssetReference.None),
            (YamlMappingNode a, YamlMappingNode b) => BetweenFields(a, b, path, prefab),
            (YamlSequenceNode a, YamlSequenceNode b) => BetweenItems(a, b, path, prefab),
            _ => throw prefab.Place.In(path).Error(AssetFault.Outdated, "has another node type in its prefab's file; write the prefab again first"),
        };
    }

    static IEnumerable<Modification> BetweenFields(YamlMappingNode before, YamlMappingNode now, string path, FileObject prefab)
    {
        // A list element that an instance adds contains only the modified fields.
        var isAdded = path.Contains(".Array.data[") && before.Children.Keys.All(now.Children.ContainsKey);
        if (!isAdded && !before.Children.Keys.SequenceEqual(now.Children.Keys))
            throw prefab.Place.Error(AssetFault.Outdated, path + " has other fields in its prefab's file; write the prefab again first");
        return now.Children.SelectMany(f => before.Children.TryGetValue(f.Key, out var old)
            ? Between(old, f.Value, Join(path, f.Key), prefab)
            : All(f.Value, Join(path, f.Key)));
    }

    static IEnumerable<Modification> BetweenItems(YamlSequenceNode before, YamlSequenceNode now, string path, FileObject prefab)
    {
        var count = before.Children.Count;
        if (count != now.Children.Count) yield return new Modification(path + ".Array.size", Numbers.Write(now.Children.Count), AssetReference.None);
        for (var i = 0; i < now.Children.Count; i++)
        {
            var item = path + ".Array.data[" + Numbers.Write(i) + "]";
            // An added element starts as a copy of the last element of the prefab's list; if the list is empty, it starts empty.
            var changes = count == 0 ? All(now.Children[i], item) : Between(before.Children[Math.Min(i, count - 1)], now.Children[i], item, prefab);
            foreach (var change in changes) yield return change;
        }
    }

    /// <summary>Returns all values except empty strings and empty references, which are the defaults.</summary>
    public static IEnumerable<Modification> All(YamlNode now, string path)
    {
        if (AssetReference.TryRead(now, out var reference)) return reference.IsNone ? Array.Empty<Modification>() : One(path, "", reference);
        return now switch
        {
            YamlScalarNode scalar => scalar.Value.Length == 0 ? Array.Empty<Modification>() : One(path, scalar.Value, AssetReference.None),
            YamlMappingNode mapping => mapping.Children.SelectMany(f => All(f.Value, Join(path, f.Key))),
            YamlSequenceNode sequence => AllItems(sequence, path),
            _ => Array.Empty<Modification>(),
        };
    }

    static IEnumerable<Modification> AllItems(YamlSequenceNode now, string path)
    {
        var size = new Modification(path + ".Array.size", Numbers.Write(now.Children.Count), AssetReference.None);
        return now.Children.SelectMany((item, i) => All(item, path + ".Array.data[" + Numbers.Write(i) + "]")).Prepend(size);
    }

    static Modification[] One(string path, string value, AssetReference reference) => new[] { new Modification(path, value, reference) };

    static string Join(string path, YamlNode name) => path.Length == 0 ? ((YamlScalarNode)name).Value : path + "." + ((YamlScalarNode)name).Value;
}
