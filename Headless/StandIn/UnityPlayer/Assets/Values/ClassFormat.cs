namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>
/// Format of a [Serializable] class or struct: its fields by name. The format does not support null. In its place, Unity writes an object with
/// default values.
/// </summary>
sealed class ClassFormat(Type type) : IValueFormat
{
    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var value = current ?? New();
        FieldValues.Read(place.Mapping(node), value, references, place);
        return value;
    }

    public YamlNode Write(object value, FileReferences references, Place place) => FieldValues.Write(value ?? New(), references, place);

    object New() => Activator.CreateInstance(type, nonPublic: true);
}
