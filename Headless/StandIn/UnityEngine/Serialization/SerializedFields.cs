using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Serialization;

/// <summary>The fields of a class that Unity serialises and Instantiate copies, by its documented rules.</summary>
static class SerializedFields
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    static readonly ConcurrentDictionary<Type, FieldInfo[]> Known = new();

    /// <summary>Gets the fields, those of the base classes first, each in the order of the source.</summary>
    internal static IReadOnlyList<FieldInfo> Of(Type type) => Known.GetOrAdd(type, Read);

    /// <summary>Finds a field by its current or former name in files; null if there is none.</summary>
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

    /// <summary>Gets the field's name in files.</summary>
    internal static string NameOf(FieldInfo field) => field.GetCustomAttribute<SerializedNameAttribute>()?.Name ?? field.Name;

    internal static bool IsList(Type type) => type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>);

    /// <summary>Whether a class or struct is serialised field by field.</summary>
    internal static bool IsNested(Type type) =>
        !type.IsPrimitive && !type.IsEnum && type != typeof(string) && !typeof(Object).IsAssignableFrom(type) && !type.IsAbstract &&
        !typeof(Delegate).IsAssignableFrom(type) &&
        (type.IsSerializable || IsEngineValue(type)) && type.Namespace?.StartsWith("System", StringComparison.Ordinal) != true;

    /// <summary>Whether the type is a vector, a colour or similar.</summary>
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
