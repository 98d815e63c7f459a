using System.Reflection;
using System.Runtime.CompilerServices;

namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>Writes a type in the format of the list of Unity's API: kind, name, base types, constraints.</summary>
static class TypeLines
{
    internal static string Of(Type type)
    {
        if (typeof(Delegate).IsAssignableFrom(type))
        {
            var invoke = type.GetMethod("Invoke");
            return $"type delegate {TypeNames.Of(type)}({ApiLines.Parameters(invoke.GetParameters())}) : {TypeNames.Of(invoke.ReturnType)}";
        }

        var bases = type.IsEnum ? "" : string.Join(", ", Bases(type).Select(TypeNames.Of));
        var name = TypeNames.Of(type) + (bases.Length > 0 ? " : " + bases : "");
        return $"type {Kind(type)} {name}{Constraints(type.GetGenericArguments())}{Attributes(type)}";
    }

    internal static string Constraints(Type[] parameters) =>
        string.Concat(parameters.Select(p => (p.Name, Constraint(p))).Where(c => c.Item2.Length > 0).Select(c => $" where {c.Name} : {c.Item2}"));

    static string Constraint(Type parameter)
    {
        if (!parameter.IsGenericParameter) return "";

        return parameter.GenericParameterAttributes.HasFlag(GenericParameterAttributes.NotNullableValueTypeConstraint)
            ? "struct"
            : string.Join(", ", parameter.GetGenericParameterConstraints().Select(TypeNames.Of));
    }

    static string Kind(Type type)
    {
        if (type.IsEnum) return "enum";
        if (type.IsInterface) return "interface";
        if (type.IsValueType) return type.IsDefined(typeof(IsReadOnlyAttribute), false) ? "readonly struct" : "struct";

        return (type.IsAbstract, type.IsSealed) switch
        {
            (true, true) => "static class",
            (true, false) => "abstract class",
            (false, true) => "sealed class",
            _ => "class",
        };
    }

    static IEnumerable<Type> Bases(Type type)
    {
        var parent = type.BaseType == typeof(object) || type.BaseType == typeof(ValueType) ? null : type.BaseType;
        var own = type.GetInterfaces().Except(parent?.GetInterfaces() ?? Type.EmptyTypes);
        return parent == null ? own : own.Prepend(parent);
    }

    static string Attributes(Type type)
    {
        if (type.IsEnum) return type.IsDefined(typeof(FlagsAttribute), false) ? "   [Flags]" : "";

        var usage = type.GetCustomAttributesData().FirstOrDefault(a => a.AttributeType == typeof(AttributeUsageAttribute));
        if (usage == null) return "";

        // Sorts the arguments, because reflection does not return them in the order of the source.
        var named = usage.NamedArguments.OrderByDescending(n => n.MemberName, StringComparer.Ordinal)
            .Select(n => $"{n.MemberName} = {((bool)n.TypedValue.Value ? "true" : "false")}");
        var targets = ((AttributeTargets)(int)usage.ConstructorArguments[0].Value).ToString();
        return $"   [AttributeUsage({string.Join(", ", named.Prepend(targets))})]";
    }
}
