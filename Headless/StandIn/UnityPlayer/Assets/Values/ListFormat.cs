using System;
using System.Collections;
using System.Collections.Generic;
using YamlDotNet.RepresentationModel;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of an array or a List: each item follows a dash. An empty list and null are written as <c>[]</c>.</summary>
sealed class ListFormat : IValueFormat
{
    readonly Type _type;
    readonly Type _item;

    public ListFormat(Type type, Type item)
    {
        _type = type;
        _item = item;
    }

    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var sequence = place.Sequence(node);
        var format = ValueFormats.For(_item);
        var items = (IList)Activator.CreateInstance(typeof(List<>).MakeGenericType(_item));
        for (var i = 0; i < sequence.Children.Count; i++) items.Add(format.Read(sequence.Children[i], null, references, place.At(i)));
        if (!_type.IsArray) return items;

        var array = Array.CreateInstance(_item, items.Count);
        items.CopyTo(array, 0);
        return array;
    }

    public YamlNode Write(object value, FileReferences references, Place place)
    {
        var list = Nodes.List();
        var format = ValueFormats.For(_item);
        foreach (var item in (IEnumerable)value ?? Array.Empty<object>()) list.Add(format.Write(item, references, place.At(list.Children.Count)));
        return list;
    }
}
