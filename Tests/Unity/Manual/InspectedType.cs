using System.Globalization;
using System.Reflection;
using System.Text.RegularExpressions;
using Nowpose.ArFoundation;
using Nowpose.Editor;
using Nowpose.Mrtk3;
using Nowpose.OpenXR;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>A component or asset of the package as a user sees it in a menu, in the Inspector and in a script.</summary>
sealed partial class InspectedType
{
    const string MenuPrefix = "Nowpose/";

    readonly Type _type;

    public InspectedType(Type type) => _type = type;

    /// <summary>All components and assets of the package's runtime, including those for optional packages, and the package's importers.</summary>
    public static IEnumerable<Type> All => Concrete(typeof(MrilSession), typeof(MonoBehaviour), typeof(ScriptableObject))
        .Concat(Concrete(typeof(HeadsetMenu), typeof(MonoBehaviour)))
        .Concat(Concrete(typeof(ArSpatialAnchors), typeof(MonoBehaviour)))
        .Concat(Concrete(typeof(OpenXrDisplayTime), typeof(MonoBehaviour)))
        .Concat(Concrete(typeof(QrMarkers), typeof(MonoBehaviour)))
        .Concat(Concrete(typeof(SetupWindow), typeof(AssetImporter)));

    /// <summary>Name in the menu, for example Robot Rig, or the name of an importer; null if the type is not in a menu.</summary>
    public string Title
    {
        get
        {
            if (typeof(AssetImporter).IsAssignableFrom(_type)) return Label(_type.Name);
            var menu = _type.GetCustomAttribute<AddComponentMenu>()?.componentMenu ?? _type.GetCustomAttribute<CreateAssetMenuAttribute>()?.menuName;
            return menu != null && menu.StartsWith(MenuPrefix, StringComparison.Ordinal) ? menu.Substring(MenuPrefix.Length) : null;
        }
    }

    public string PageName => Title?.ToLowerInvariant().Replace(' ', '-') + ".md";

    /// <summary>Fields in the Inspector from top to bottom. The fields of the elements of a list follow the list.</summary>
    public IReadOnlyList<InspectedField> Fields => FieldsOf(_type, "").ToList();

    /// <summary>Members that a script can use, without the members of Unity's base classes.</summary>
    public IReadOnlyList<string> Members => _type
        .GetMembers(BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly)
        .Where(m => m is not ConstructorInfo && (m is not MethodInfo method || (!method.IsSpecialName && method.GetBaseDefinition() == method)))
        .Where(m => m is not FieldInfo data || !IsShown(data))
        .Select(m => m.Name)
        .Distinct()
        .ToList();

    static IEnumerable<Type> Concrete(Type ofAssembly, params Type[] bases) => ofAssembly.Assembly.GetTypes()
        .Where(t => !t.IsAbstract && bases.Any(b => b.IsAssignableFrom(t)));

    static IEnumerable<InspectedField> FieldsOf(Type type, string prefix)
    {
        var made = Activator.CreateInstance(type, nonPublic: true);
        // Reflection does not guarantee an order. The metadata tokens of the fields increase in the order of the source.
        foreach (var field in type.GetFields(BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.DeclaredOnly)
            .Where(IsShown).OrderBy(f => f.MetadataToken))
        {
            var label = prefix + Label(field.Name);
            yield return new InspectedField(
                label, Text(field.GetValue(made), field.FieldType), ElementOf(field.FieldType), field.GetCustomAttribute<RangeAttribute>(),
                field.GetCustomAttribute<TooltipAttribute>()?.tooltip);
            foreach (var nested in FieldsOfOwn(field.FieldType, label + " › ")) yield return nested;
        }
    }

    static IEnumerable<InspectedField> FieldsOfOwn(Type type, string prefix)
    {
        var element = ElementOf(type);
        var isOwn = element.Assembly.GetName().Name.StartsWith("Nowpose", StringComparison.Ordinal) && !element.IsEnum && !typeof(Object).IsAssignableFrom(element);
        return isOwn ? FieldsOf(element, prefix) : Enumerable.Empty<InspectedField>();
    }

    static Type ElementOf(Type type) => type.IsArray ? type.GetElementType() : typeof(System.Collections.IEnumerable).IsAssignableFrom(type) && type.IsGenericType ? type.GetGenericArguments()[0] : type;

    static bool IsShown(FieldInfo field) =>
        !field.IsInitOnly && !field.IsStatic && !field.IsLiteral && !field.IsDefined(typeof(NonSerializedAttribute))
        && (field.IsPublic || field.IsDefined(typeof(SerializeField))) && !field.IsDefined(typeof(HideInInspector));

    /// <summary>Returns the label that Unity shows for the name of a field: without its prefix, in separate words, with a capital letter.</summary>
    public static string Label(string name)
    {
        var bare = Prefix().Replace(name, "");
        return char.ToUpperInvariant(bare[0]) + WordStart().Replace(bare.Substring(1), " ");
    }

    static string Text(object value, Type type)
    {
        if (type == typeof(bool)) return (bool)value ? "on" : "off";
        if (type.IsEnum) return Label(value.ToString());
        if (typeof(UnityEventBase).IsAssignableFrom(type) || typeof(Object).IsAssignableFrom(type)) return "none";
        if (value is string text) return text.Length == 0 ? "empty" : "`" + text + "`";
        if (value is System.Collections.ICollection list) return list.Count == 0 ? "empty" : list.Count.ToString(CultureInfo.InvariantCulture);
        return Convert.ToString(value, CultureInfo.InvariantCulture);
    }

    [GeneratedRegex("^(m_|_|k(?=[A-Z]))")]
    private static partial Regex Prefix();

    [GeneratedRegex("(?=[A-Z][a-z])|(?<=[a-z])(?=[A-Z])")]
    private static partial Regex WordStart();
}
