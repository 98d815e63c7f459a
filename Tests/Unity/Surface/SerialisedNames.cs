using System.Reflection;
using System.Text.RegularExpressions;
using Nowpose.Unity.Tests.Manual;
using UnityEngine;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Surface;

/// <summary>
/// Lists the names in the package that scenes, prefabs and assets of a user's project store, one per line: GUIDs with their files, components,
/// serialised fields with their types, values of enums, and methods that events can call.
/// </summary>
static partial class SerialisedNames
{
    const BindingFlags Declared = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    static readonly Type[] Arguments = [typeof(int), typeof(float), typeof(string), typeof(bool)];

    public static IEnumerable<string> All => Guids().Concat(InspectedType.All.SelectMany(WithBases).Distinct().SelectMany(OfComponent)).Distinct();

    static IEnumerable<string> Guids()
    {
        var scripts = InspectedType.All.ToDictionary(type => type.Name + ".cs", type => type.FullName);
        foreach (var meta in RepositoryFiles.Under("Packages", ".meta").Concat(RepositoryFiles.Under("Assets", ".meta")))
        {
            var guid = Guid().Match(RepositoryFiles.Read(meta)).Groups[1].Value;
            var file = Path.GetFileNameWithoutExtension(meta);
            yield return $"asset {guid} {file}";
            if (scripts.TryGetValue(file, out var type)) yield return $"script {guid} {type}";
        }
    }

    /// <summary>Returns a type of the package and its base types in the package.</summary>
    public static IEnumerable<Type> WithBases(Type type)
    {
        for (var at = type; IsOfPackage(at); at = at.BaseType) yield return at;
    }

    static IEnumerable<string> OfComponent(Type type) => Fields(type).Concat(type.GetMethods(Declared)
        .Where(method => method.IsPublic && method.ReturnType == typeof(void) && CanBeCalled(method.GetParameters()))
        .Where(method => !method.IsSpecialName || method.Name.StartsWith("set_", StringComparison.Ordinal))
        .Select(method => $"method {type.FullName}.{method.Name}({string.Join(", ", method.GetParameters().Select(p => NameOf(p.ParameterType)))})"));

    static bool CanBeCalled(ParameterInfo[] parameters) => parameters.Length == 0
        || (parameters.Length == 1 && (Arguments.Contains(parameters[0].ParameterType) || typeof(Object).IsAssignableFrom(parameters[0].ParameterType)));

    static IEnumerable<string> Fields(Type type)
    {
        foreach (var field in type.GetFields(Declared).Where(IsSerialised))
        {
            foreach (var name in field.GetCustomAttributes<FormerlySerializedAsAttribute>().Select(former => former.oldName).Prepend(field.Name))
                yield return $"field {type.FullName}.{name} {NameOf(field.FieldType)}";
            foreach (var line in OfType(field.FieldType)) yield return line;
        }
    }

    static IEnumerable<string> OfType(Type type)
    {
        if (type.IsArray) return OfType(type.GetElementType());
        if (type.IsGenericType) return type.GetGenericArguments().SelectMany(OfType);
        if (!IsOfPackage(type) || typeof(Object).IsAssignableFrom(type)) return [];
        return type.IsEnum ? Enum.GetNames(type).Select(name => $"value {type.FullName}.{name} {(int)Enum.Parse(type, name)}") : Fields(type);
    }

    static bool IsSerialised(FieldInfo field) => !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute))
        && (field.IsPublic || field.IsDefined(typeof(SerializeField)));

    static string NameOf(Type type)
    {
        if (type.IsArray) return NameOf(type.GetElementType()) + "[]";
        if (type.IsGenericType) return $"{type.Name.Split('`')[0]}<{string.Join(", ", type.GetGenericArguments().Select(NameOf))}>";
        return IsOfPackage(type) ? type.FullName : type.Name;
    }

    static bool IsOfPackage(Type type) => type.Assembly.GetName().Name.StartsWith("Nowpose", StringComparison.Ordinal);

    [GeneratedRegex("^guid: (\\w+)", RegexOptions.Multiline)]
    private static partial Regex Guid();
}
