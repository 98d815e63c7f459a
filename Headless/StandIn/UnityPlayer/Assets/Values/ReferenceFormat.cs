namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of a reference to an object. The empty reference is <c>{fileID: 0}</c>.</summary>
sealed class ReferenceFormat(Type type) : IValueFormat
{
    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        if (!AssetReference.TryRead(node, out var reference))
            throw place.Error(AssetFault.Kind, "has to be a reference: {fileID: …} or {fileID: …, guid: …, type: …}");
        return reference.IsNone ? null : references.ObjectAt(reference, type, place);
    }

    public YamlNode Write(object value, FileReferences references, Place place)
    {
        var target = (Object)value;
        return (target == null ? AssetReference.None : references.ReferenceTo(target, place)).Write();
    }
}
