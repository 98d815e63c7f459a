using YamlDotNet.Core.Events;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A class of objects in Unity's asset files: its class ID, its name and its serialised fields in the order of the file.</summary>
class ObjectClass(int id, string name, Type type, params Slot[] slots)
{
    public int Id { get; } = id;
    public string Name { get; } = name;

    /// <summary>The stand-in's type for this class.</summary>
    public Type Type { get; } = type;

    /// <summary>Sets those fields of an object that the file contains. The other fields keep their default values.</summary>
    /// <exception cref="AssetException">The file contains a field that the class does not have, or an invalid value.</exception>
    public void Read(YamlMappingNode fields, Object target, FileReferences references, Place place)
    {
        var unread = fields.Children.ToDictionary(f => place.Scalar(f.Key), f => f.Value);
        foreach (var slot in slots)
        {
            if (unread.Remove(slot.Name, out var node)) slot.Read(target, node, references, place);
        }
        foreach (var field in unread) ReadOther(field.Key, field.Value, target, references, place);
        (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
    }

    public YamlMappingNode Write(Object source, FileReferences references, Place place)
    {
        (source as ISerializationCallbackReceiver)?.OnBeforeSerialize();
        var fields = new YamlMappingNode { Style = MappingStyle.Block };
        foreach (var slot in slots) fields.Add(slot.Name, slot.Write(source, references, place));
        foreach (var (name, value) in WriteOthers(source)) fields.Add(name, value);
        return fields;
    }

    protected virtual void ReadOther(string name, YamlNode node, Object target, FileReferences references, Place place) =>
        throw place.Error(AssetFault.UnknownField, Type.Name + " has no serialised field " + name);

    protected virtual IEnumerable<(string Name, YamlNode Value)> WriteOthers(Object source) => Array.Empty<(string, YamlNode)>();
}
