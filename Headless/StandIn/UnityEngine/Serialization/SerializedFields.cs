using System.Collections.Concurrent;
using System.Reflection;

namespace UnityEngine.Serialization;

/// <summary>Finds the fields of a class that Unity serialises, according to Unity's documented rules. Instantiate copies these fields.</summary>
static class SerializedFields
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    static readonly ConcurrentDictionary<Type, FieldInfo[]> Known = new();

    /// <summary>Returns the fields in source order, those of base classes first.</summary>
    internal static IReadOnlyList<FieldInfo> Of(Type type) => Known.GetOrAdd(type, Read);

    /// <summary>Returns the field that is or was formerly serialised under this name; null if there is none.</summary>
    internal static FieldInfo Find(Type type, string name)
    {
        foreach (var field in Of(type))
        {
            if (NameOf(field) == name) return field;
        }

        foreach (var field in Of(type))
        {
            foreach (var former in field.GetCustomAttributes<FormerlySerializedAsAttribute>())
            {
                if (former.oldName == name) return field;
            }
        }

        return null;
    }

    /// <summary>Returns the name under which a field is stored in files.</summary>
    internal static string NameOf(FieldInfo field) => field.GetCustomAttribute<SerializedNameAttribute>()?.Name ?? field.Name;

    internal static bool IsList(Type type) => type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>);

    /// <summary>Returns whether Unity serialises a class or struct field by field.</summary>
    internal static bool IsNested(Type type) =>
        !type.IsPrimitive && !type.IsEnum && type != typeof(string) && !typeof(Object).IsAssignableFrom(type) && !type.IsAbstract &&
        !typeof(Delegate).IsAssignableFrom(type) &&
        (type.IsSerializable || IsEngineValue(type)) && type.Namespace?.StartsWith("System", StringComparison.Ordinal) != true;

    /// <summary>Returns whether a type is a struct of Unity, for example a vector or a colour.</summary>
    internal static bool IsEngineValue(Type type) => type.IsValueType && type.Assembly == typeof(Object).Assembly;

    static FieldInfo[] Read(Type type)
    {
        var fields = new List<FieldInfo>();
        if (type.BaseType != null) fields.AddRange(Of(type.BaseType));
        foreach (var field in type.GetFields(Declared))
        {
            var wanted = field.IsPublic ? !field.IsNotSerialized : field.IsDefined(typeof(SerializeField));
            if (wanted && !field.IsInitOnly && IsKept(field.FieldType, true)) fields.Add(field);
        }

        return fields.ToArray();
    }

    static bool IsKept(Type type, bool lists)
    {
        if (type.IsArray) return lists && type.GetArrayRank() == 1 && IsKept(type.GetElementType(), false);
        if (IsList(type)) return lists && IsKept(type.GetGenericArguments()[0], false);

        return type.IsPrimitive || type.IsEnum || type == typeof(string) || typeof(Object).IsAssignableFrom(type) || IsNested(type);
    }
}
