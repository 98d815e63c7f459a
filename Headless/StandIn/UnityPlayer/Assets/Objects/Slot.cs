using UnityEngine.Serialization;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>One field of a class in files, with the functions that read and write it.</summary>
sealed class Slot(
    string name, Action<Object, YamlNode, FileReferences, Place> read, Func<Object, FileReferences, Place, YamlNode> write)
{
    public string Name { get; } = name;

    /// <summary>Creates a field that the stand-in does not use. In files, it must have the given value.</summary>
    public static Slot Constant(string name, YamlNode value)
    {
        return new Slot(
            name,
            (_, node, _, place) =>
            {
                if (!node.Equals(value)) throw place.Error(AssetFault.Unsupported, "the stand-in supports only " + value + " here, not " + node);
            },
            (_, _, _) => value);
    }

    /// <summary>Creates a field that is read and written through a property of the object.</summary>
    public static Slot Property<TObject, TValue>(string name, Func<TObject, TValue> get, Action<TObject, TValue> set, IValueFormat format = null)
        where TObject : Object
    {
        format ??= ValueFormats.For(typeof(TValue));
        return new Slot(
            name,
            (target, node, references, place) => set((TObject)target, (TValue)format.Read(node, get((TObject)target), references, place)),
            (target, references, place) => format.Write(get((TObject)target), references, place));
    }

    /// <summary>Creates a field whose value follows from the hierarchy. Reading checks that the file contains this value.</summary>
    public static Slot Checked<TObject, TValue>(string name, Func<TObject, TValue> get)
        where TObject : Object
    {
        var format = ValueFormats.For(typeof(TValue));
        return Checked<TObject>(name, (target, references, place) => format.Write(get(target), references, place));
    }

    /// <inheritdoc cref="Checked{TObject,TValue}"/>
    public static Slot Checked<TObject>(string name, Func<TObject, FileReferences, Place, YamlNode> write)
        where TObject : Object
    {
        return new Slot(
            name,
            (target, node, references, place) =>
            {
                var expected = write((TObject)target, references, place);
                if (!node.Equals(expected)) throw place.Error(AssetFault.Hierarchy, "is " + node + ", but the hierarchy has " + expected);
            },
            (target, references, place) => write((TObject)target, references, place));
    }

    /// <summary>Creates a field that only Unity's editor uses. It is written but not read.</summary>
    public static Slot Hint<TObject>(string name, Func<TObject, FileReferences, Place, YamlNode> write)
        where TObject : Object =>
        new Slot(name, (_, _, _, _) => { }, (target, references, place) => write((TObject)target, references, place));

    /// <summary>Creates a field for a serialised field of the object's type.</summary>
    public static Slot Field(Type type, string name, IValueFormat format = null)
    {
        var field = SerializedFields.Find(type, name) ?? throw new ArgumentException(type.Name + " has no serialised field " + name, nameof(name));
        format ??= ValueFormats.For(field.FieldType);
        return new Slot(
            name,
            (target, node, references, place) => field.SetValue(target, format.Read(node, field.GetValue(target), references, place)),
            (target, references, place) => format.Write(field.GetValue(target), references, place));
    }

    public void Read(Object target, YamlNode node, FileReferences references, Place place) => read(target, node, references, place.In(Name));

    public YamlNode Write(Object source, FileReferences references, Place place) => write(source, references, place.In(Name));
}
