using System.Globalization;
using System.Text.RegularExpressions;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>
/// Changes one value of an object, given its path as in the modifications of a prefab instance. Examples: <c>m_LocalPosition.x</c>,
/// <c>_fingers.Array.size</c>, <c>_fingers.Array.data[1].joint</c>.
/// </summary>
static class PropertyPath
{
    /// <summary>
    /// Tag of an element that was added to a list that is empty in the prefab. Only the modifications state the fields of such an element.
    /// </summary>
    static readonly TagName Open = new TagName("!open");

    static readonly Regex Element = new Regex(@"^data\[(\d+)\]\z", RegexOptions.CultureInvariant);

    /// <summary>Sets a value.</summary>
    /// <param name="fields">Fields of the object. They must contain the path, except in new list elements.</param>
    /// <param name="path">Path as in the file.</param>
    /// <param name="value">New value if it is a scalar.</param>
    /// <param name="reference">New value if it is a reference.</param>
    /// <param name="place">Place for error messages.</param>
    public static void Set(YamlMappingNode fields, string path, string value, AssetReference reference, Place place)
    {
        var steps = path.Split('.');
        YamlNode node = fields;
        Action<YamlNode> replace = null;
        for (var i = 0; i < steps.Length; i++)
        {
            if (node.Tag == Open && steps[i] == "Array") replace(node = Nodes.List());
            if (node is YamlSequenceNode sequence)
            {
                var step = steps[i] == "Array" && i + 1 < steps.Length ? steps[++i] : "";
                if (step == "size" && i == steps.Length - 1)
                {
                    Resize(sequence, value, place);
                    return;
                }
                var index = IndexOf(step, sequence, place);
                place = place.At(index);
                node = sequence.Children[index];
                replace = changed => sequence.Children[index] = changed;
                continue;
            }
            var mapping = node as YamlMappingNode ?? throw place.Error(AssetFault.UnknownField, "has no fields, so it has no " + steps[i]);
            var name = new YamlScalarNode(steps[i]);
            place = place.In(steps[i]);
            node = Part(mapping, name, place);
            replace = changed => mapping.Children[name] = changed;
        }
        replace(Changed(node, value, reference, place));
    }

    static YamlNode Part(YamlMappingNode mapping, YamlScalarNode name, Place place)
    {
        if (mapping.Children.TryGetValue(name, out var part)) return part;
        if (mapping.Tag != Open) throw place.Error(AssetFault.UnknownField, "the prefab has no such property");
        part = NewOpen();
        mapping.Add(name, part);
        return part;
    }

    static YamlNode Changed(YamlNode node, string value, AssetReference reference, Place place)
    {
        if (node.Tag == Open) return reference.IsNone ? Nodes.Text(value) : reference.Write();
        if (AssetReference.TryRead(node, out _))
            return value.Length == 0 ? reference.Write() : throw place.Error(AssetFault.Kind, "is a reference: set objectReference, not value");
        if (!(node is YamlScalarNode)) throw place.Error(AssetFault.Kind, "is not a single value; modify its fields separately");
        return reference.IsNone ? Nodes.Text(value) : throw place.Error(AssetFault.Kind, "is a value: it must not have an objectReference");
    }

    static int IndexOf(string step, YamlSequenceNode sequence, Place place)
    {
        var match = Element.Match(step);
        if (!match.Success || !int.TryParse(match.Groups[1].Value, NumberStyles.None, CultureInfo.InvariantCulture, out var index))
            throw place.Error(AssetFault.Kind, "is a list: its path must continue with Array.size or Array.data[n]");
        return index < sequence.Children.Count
            ? index
            : throw place.At(index).Error(AssetFault.OutOfRange, "is beyond the end of the list; its length is " + sequence.Children.Count);
    }

    /// <summary>Sets the size of a list. Added elements are copies of the last element.</summary>
    static void Resize(YamlSequenceNode sequence, string value, Place place)
    {
        if (!int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out var size))
            throw place.Error(AssetFault.Value, "\"" + value + "\" is not a valid list size");
        sequence.Style = SequenceStyle.Block;
        while (sequence.Children.Count > size) sequence.Children.RemoveAt(sequence.Children.Count - 1);
        while (sequence.Children.Count < size)
        {
            var count = sequence.Children.Count;
            sequence.Add(count == 0 ? NewOpen() : CopyOf(sequence.Children[count - 1]));
        }
    }

    static YamlNode CopyOf(YamlNode last) => last.Tag == Open ? NewOpen() : LocalReferences.Copy(last);

    static YamlMappingNode NewOpen() => new YamlMappingNode { Tag = Open };
}
