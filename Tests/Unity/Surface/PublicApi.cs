using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Nowpose.Unity.Tests.Surface;

/// <summary>
/// Lists the public API of an assembly in sorted order: one line for each assembly that may use its internal types, for each public type, and
/// for each public or protected member.
/// </summary>
static class PublicApi
{
    const BindingFlags Declared = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

    public static IEnumerable<string> Of(Assembly assembly) =>
        assembly.GetCustomAttributes<InternalsVisibleToAttribute>().Select(friend => $"internals visible to {friend.AssemblyName}")
            .Order(StringComparer.Ordinal)
            .Concat(assembly.GetExportedTypes().OrderBy(type => type.FullName, StringComparer.Ordinal).SelectMany(Of));

    static IEnumerable<string> Of(Type type)
    {
        yield return $"{KindOf(type)} {type.FullName}{BasesOf(type)}";
        if (type.IsEnum)
        {
            foreach (var field in type.GetFields(BindingFlags.Static | BindingFlags.Public))
                yield return string.Create(CultureInfo.InvariantCulture, $"{type.FullName}.{field.Name} = {Convert.ToInt64(field.GetRawConstantValue(), CultureInfo.InvariantCulture)}");
            yield break;
        }

        if (typeof(Delegate).IsAssignableFrom(type))
        {
            yield return $"{type.FullName}.{MethodOf(type.GetMethod("Invoke"))}";
            yield break;
        }

        foreach (var line in type.GetMembers(Declared).Select(LineOf).Where(line => line != null).Order(StringComparer.Ordinal)) yield return $"{type.FullName}.{line}";
    }

    static string KindOf(Type type) =>
        type.IsEnum ? "enum" : type.IsInterface ? "interface" : type.IsValueType ? "struct" : typeof(Delegate).IsAssignableFrom(type) ? "delegate"
        : type.IsAbstract && type.IsSealed ? "static class" : type.IsAbstract ? "abstract class" : type.IsSealed ? "sealed class" : "class";

    static string BasesOf(Type type)
    {
        if (type.IsEnum || typeof(Delegate).IsAssignableFrom(type)) return "";
        var inherited = type.BaseType?.GetInterfaces() ?? [];
        var bases = type.GetInterfaces().Except(inherited).Where(each => each.IsPublic).Select(NameOf).Order(StringComparer.Ordinal).ToList();
        if (type.BaseType is { } of && of != typeof(object) && of != typeof(ValueType)) bases.Insert(0, NameOf(of));
        return bases.Count == 0 ? "" : " : " + string.Join(", ", bases);
    }

    // Returns the line of a member; null if users cannot access the member.
    static string LineOf(MemberInfo member) => member switch
    {
        ConstructorInfo made when IsVisible(made) && !made.IsStatic => $"new({ParametersOf(made)})",
        MethodInfo method when IsVisible(method) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)) => MethodOf(method),
        PropertyInfo property => PropertyOf(property),
        EventInfo raised when IsVisible(raised.AddMethod) => $"event {raised.Name} : {NameOf(raised.EventHandlerType)}",
        FieldInfo field when field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly => $"{(field.IsLiteral ? "const " : field.IsStatic ? "static " : "")}{field.Name} : {NameOf(field.FieldType)}",
        _ => null,
    };

    static string MethodOf(MethodInfo method) => $"{(method.IsStatic ? "static " : "")}{method.Name}({ParametersOf(method)}) : {NameOf(method.ReturnType)}";

    static string PropertyOf(PropertyInfo property)
    {
        var accessors = (IsVisible(property.GetMethod) ? "get; " : "") + (IsVisible(property.SetMethod) ? "set; " : "");
        if (accessors.Length == 0) return null;
        var either = property.GetMethod ?? property.SetMethod;
        var indices = property.GetIndexParameters().Length == 0 ? "" : $"[{string.Join(", ", property.GetIndexParameters().Select(each => NameOf(each.ParameterType)))}]";
        return $"{(either.IsStatic ? "static " : "")}{property.Name}{indices} : {NameOf(property.PropertyType)} {{ {accessors}}}";
    }

    static string ParametersOf(MethodBase method) => string.Join(", ", method.GetParameters().Select(
        each => $"{(each.IsOut ? "out " : each.IsIn ? "in " : each.ParameterType.IsByRef ? "ref " : "")}{NameOf(each.ParameterType)} {each.Name}{(each.IsOptional ? "?" : "")}"));

    static bool IsVisible(MethodBase method) => method != null && (method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly);

    static string NameOf(Type type)
    {
        if (type.IsByRef) return NameOf(type.GetElementType());
        if (type.IsArray) return NameOf(type.GetElementType()) + "[]";
        if (Nullable.GetUnderlyingType(type) is { } value) return NameOf(value) + "?";
        var name = type.IsNested && !type.IsGenericParameter ? $"{NameOf(type.DeclaringType)}.{type.Name}" : type.Name;
        return type.IsGenericType ? $"{name.Split('`')[0]}<{string.Join(", ", type.GetGenericArguments().Select(NameOf))}>" : name;
    }
}
