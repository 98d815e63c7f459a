using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>Lists the public members of an assembly, one per line, in the format of the list of Unity's API.</summary>
static class ApiLines
{
    const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    /// <summary>Returns the lines of a type. The first line is for the type itself.</summary>
    internal static IEnumerable<string> Of(Type type)
    {
        yield return TypeLines.Of(type);
        if (typeof(Delegate).IsAssignableFrom(type)) yield break;

        foreach (var member in type.GetMembers(Declared))
        {
            if (Line(type, member) is { } line) yield return line;
        }
    }

    static string Line(Type type, MemberInfo member) => member switch
    {
        FieldInfo field when IsVisible(field) && !field.IsSpecialName => FieldLine(type, field),
        PropertyInfo property when property.GetAccessors(true).Any(IsVisible) => PropertyLine(property),
        EventInfo { AddMethod: { } add } e when IsVisible(add) => $"{Modifiers(add)}event {Name(e)} : {TypeNames.Of(e.EventHandlerType)}",
        ConstructorInfo { IsStatic: false } constructor when IsVisible(constructor) =>
            $"{Protected(constructor)}{Name(constructor)}({Parameters(constructor.GetParameters())})",
        MethodInfo method when IsVisible(method) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)) =>
            MethodLine(method),
        _ => null,
    };

    static string FieldLine(Type type, FieldInfo field)
    {
        if (type.IsEnum) return $"enum {Name(field)} = {Convert.ToInt64(field.GetRawConstantValue(), CultureInfo.InvariantCulture)}";

        var modifiers = field.IsLiteral ? "const " : (field.IsStatic ? "static " : "") + (field.IsInitOnly ? "readonly " : "");
        var value = field.IsLiteral ? " = " + Constant(field.GetRawConstantValue()) : "";
        return $"{modifiers}field {Name(field)} : {TypeNames.Of(field.FieldType)}{value}";
    }

    static string PropertyLine(PropertyInfo property)
    {
        var accessors = Accessor(property.GetMethod, property.SetMethod, "get; ") + Accessor(property.SetMethod, property.GetMethod, "set; ");
        var index = property.GetIndexParameters();
        var name = index.Length == 0 ? Name(property) : $"{TypeNames.Of(property.DeclaringType)}.this[{Parameters(index)}]";
        return $"{Modifiers(property.GetAccessors(true).First(IsVisible))}{name} {{ {accessors}}} : {TypeNames.Of(property.PropertyType)}";
    }

    static string Accessor(MethodInfo accessor, MethodInfo other, string name)
    {
        if (!IsVisible(accessor)) return "";
        return (!accessor.IsPublic && other is { IsPublic: true } ? "protected " : "") + name;
    }

    static string MethodLine(MethodInfo method)
    {
        var arguments = method.GetGenericArguments();
        var generic = arguments.Length == 0 ? "" : "<" + string.Join(", ", arguments.Select(a => a.Name)) + ">";
        return $"{Modifiers(method)}{Name(method)}{generic}({Parameters(method.GetParameters())}) : {TypeNames.Of(method.ReturnType)}" +
            TypeLines.Constraints(arguments);
    }

    // Omits the type parameters of a generic type, because the list omits them here.
    static string Name(MemberInfo member) => $"{TypeNames.Of(member.DeclaringType).Split('<')[0]}.{member.Name}";

    static bool IsVisible(FieldInfo field) => field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly;

    static bool IsVisible(MethodBase method) => method != null && (method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly);

    static string Protected(MethodBase method) => method.IsPublic ? "" : "protected ";

    static string Modifiers(MethodInfo method)
    {
        if (method.IsStatic) return Protected(method) + "static ";
        if (method.DeclaringType.IsInterface || !method.IsVirtual || (method.IsFinal && IsNew(method))) return Protected(method);

        return Protected(method) + (method.IsAbstract ? "abstract " : IsNew(method) ? "virtual " : "override ");
    }

    static bool IsNew(MethodInfo method) => method.GetBaseDefinition() == method;

    internal static string Parameters(IEnumerable<ParameterInfo> parameters) => string.Join(", ", parameters.Select(Parameter));

    static string Parameter(ParameterInfo parameter)
    {
        var prefix = parameter.IsOut ? "out "
            : parameter.IsDefined(typeof(IsReadOnlyAttribute), false) ? "in "
            : parameter.ParameterType.IsByRef ? "ref "
            : parameter.IsDefined(typeof(ParamArrayAttribute), false) ? "params " : "";
        var standard = parameter.HasDefaultValue ? " = " + Constant(parameter.RawDefaultValue) : "";
        return $"{prefix}{TypeNames.Of(parameter.ParameterType)} {parameter.Name}{standard}";
    }

    static string Constant(object value) => value switch
    {
        null => "null",
        string text => $"\"{text}\"",
        bool flag => flag ? "true" : "false",
        _ => Convert.ToString(value, CultureInfo.InvariantCulture),
    };
}
