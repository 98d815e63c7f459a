using System.Reflection;
using UnityEngine.Serialization;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Reads and writes the serialised fields of a C# object as named values.</summary>
static class FieldValues
{
    /// <summary>Sets the fields that the file contains. The other fields keep their values.</summary>
    /// <exception cref="AssetException">The file contains a field that the class does not serialise, or an invalid value.</exception>
    public static void Read(YamlMappingNode mapping, object target, FileReferences references, Place place)
    {
        foreach (var entry in mapping.Children)
        {
            var name = place.Scalar(entry.Key);
            var field = SerializedFields.Find(target.GetType(), name)
                ?? throw place.Error(AssetFault.UnknownField, target.GetType().Name + " has no serialised field " + name);
            Read(field, entry.Value, target, references, place);
        }
        (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
    }

    public static void Read(FieldInfo field, YamlNode node, object target, FileReferences references, Place place) =>
        field.SetValue(target, ValueFormats.For(field.FieldType).Read(node, field.GetValue(target), references, place.In(field.Name)));

    public static YamlMappingNode Write(object source, FileReferences references, Place place)
    {
        (source as ISerializationCallbackReceiver)?.OnBeforeSerialize();
        return Nodes.Lines(SerializedFields.Of(source.GetType())
            .Select(f => (SerializedFields.NameOf(f), Write(f, source, references, place))).ToArray());
    }

    public static YamlNode Write(FieldInfo field, object source, FileReferences references, Place place) =>
        ValueFormats.For(field.FieldType).Write(field.GetValue(source), references, place.In(field.Name));
}
