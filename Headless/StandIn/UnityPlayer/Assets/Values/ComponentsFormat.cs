using System.Reflection;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Format of a vector, quaternion or colour: its components by name, in braces.</summary>
sealed class ComponentsFormat(Type type, params string[] components) : IValueFormat
{
    readonly FieldInfo[] _components = components.Select(c => type.GetField(c)).ToArray();

    public object Read(YamlNode node, object current, FileReferences references, Place place)
    {
        var mapping = place.Mapping(node);
        var value = current ?? Activator.CreateInstance(type);
        foreach (var entry in mapping.Children)
        {
            var name = place.Scalar(entry.Key);
            var component = Array.Find(_components, c => c.Name == name)
                ?? throw place.Error(AssetFault.UnknownField, type.Name + " has no " + name);
            component.SetValue(value, ValueFormats.For(component.FieldType).Read(entry.Value, null, references, place.In(name)));
        }
        return value;
    }

    public YamlNode Write(object value, FileReferences references, Place place) =>
        Nodes.Braces(_components
            .Select(c => (c.Name, ValueFormats.For(c.FieldType).Write(c.GetValue(value), references, place.In(c.Name)))).ToArray());
}
