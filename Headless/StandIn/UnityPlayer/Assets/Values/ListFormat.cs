using System.Collections;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of an array or a List: each item follows a dash. An empty list and null are written as <c>[]</c>.</summary>
sealed class ListFormat(Type type, Type itemType) : IValueFormat
{
    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var sequence = place.Sequence(node);
        var format = ValueFormats.For(itemType);
        var items = (IList)Activator.CreateInstance(typeof(List<>).MakeGenericType(itemType));
        for (var i = 0; i < sequence.Children.Count; i++) items.Add(format.Read(sequence.Children[i], null, references, place.At(i)));
        if (!type.IsArray) return items;

        var array = Array.CreateInstance(itemType, items.Count);
        items.CopyTo(array, 0);
        return array;
    }

    public YamlNode Write(object value, FileReferences references, Place place)
    {
        var list = Nodes.List();
        var format = ValueFormats.For(itemType);
        foreach (var item in (IEnumerable)value ?? Array.Empty<object>()) list.Add(format.Write(item, references, place.At(list.Children.Count)));
        return list;
    }
}
