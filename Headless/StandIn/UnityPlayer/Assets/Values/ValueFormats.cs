using System.Collections.Concurrent;
using UnityEngine.Serialization;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Finds the format for each type that Unity serialises.</summary>
static class ValueFormats
{
    static readonly Dictionary<Type, IValueFormat> Simple = new Dictionary<Type, IValueFormat>
    {
        [typeof(bool)] = new ScalarFormat<bool>(TryReadBool, v => v ? "1" : "0"),
        [typeof(byte)] = Integer(v => (byte)v, v => v),
        [typeof(short)] = Integer(v => (short)v, v => v),
        [typeof(ushort)] = Integer(v => (ushort)v, v => v),
        [typeof(int)] = Integer(v => (int)v, v => v),
        [typeof(uint)] = Integer(v => (uint)v, v => v),
        [typeof(long)] = Integer(v => v, v => v),
        [typeof(float)] = new ScalarFormat<float>(Numbers.TryRead, Numbers.Write),
        [typeof(double)] = new ScalarFormat<double>(Numbers.TryRead, Numbers.Write),
        [typeof(string)] = new ScalarFormat<string>(TryReadText, v => v ?? ""),
        [typeof(Vector2)] = new ComponentsFormat(typeof(Vector2), "x", "y"),
        [typeof(Vector3)] = new ComponentsFormat(typeof(Vector3), "x", "y", "z"),
        [typeof(Vector4)] = new ComponentsFormat(typeof(Vector4), "x", "y", "z", "w"),
        [typeof(Quaternion)] = new ComponentsFormat(typeof(Quaternion), "x", "y", "z", "w"),
        [typeof(Color)] = new ComponentsFormat(typeof(Color), "r", "g", "b", "a"),
        [typeof(Color32)] = new ColourFormat(),
    };

    static readonly ConcurrentDictionary<Type, IValueFormat> Composed = new ConcurrentDictionary<Type, IValueFormat>();

    /// <summary>Returns the format for a type.</summary>
    /// <exception cref="NotSupportedException">Unity serialises the type, but this class does not support it.</exception>
    public static IValueFormat For(Type type) => Simple.TryGetValue(type, out var format) ? format : Composed.GetOrAdd(type, Compose);

    static IValueFormat Compose(Type type)
    {
        var item = type.IsArray ? type.GetElementType() : SerializedFields.IsList(type) ? type.GetGenericArguments()[0] : null;
        // Lists of integers are not needed and not supported: Unity writes such a list as one string of hexadecimal digits.
        if (item != null && item.IsPrimitive && item != typeof(float) && item != typeof(double))
            throw new NotSupportedException("a list of " + item.Name + " cannot be read or written yet");
        if (item != null) return new ListFormat(type, item);
        if (type.IsEnum) return new EnumFormat(type);
        if (typeof(Object).IsAssignableFrom(type)) return new ReferenceFormat(type);
        // Unity's structs are excluded, because each has a format of its own in Unity's files.
        if (SerializedFields.IsNested(type) && !(type.IsValueType && type.Assembly == typeof(Object).Assembly)) return new ClassFormat(type);
        throw new NotSupportedException("a " + type.FullName + " cannot be read or written yet");
    }

    static ScalarFormat<T> Integer<T>(Func<long, T> narrow, Func<T, long> widen)
    {
        return new ScalarFormat<T>(
            (string text, out T value) =>
            {
                var isNumber = Numbers.TryRead(text, out long number);
                value = narrow(number);
                return isNumber && widen(value) == number;
            },
            value => Numbers.Write(widen(value)));
    }

    static bool TryReadBool(string text, out bool value)
    {
        value = text == "1";
        return value || text == "0";
    }

    static bool TryReadText(string text, out string value)
    {
        value = text;
        return true;
    }
}
