namespace Nowpose.Unity.Tests.Engine.Api;

/// <summary>Writes type names in the format of the list of Unity's API.</summary>
static class TypeNames
{
    internal static string Of(Type type)
    {
        if (type.IsByRef) return Of(type.GetElementType());
        if (type.IsArray) return Of(type.GetElementType()) + "[]";
        if (type.IsGenericParameter) return type.Name;

        var outer = type.DeclaringType != null ? Of(type.DeclaringType) : type.Namespace;
        var name = type.Name.Split('`')[0];
        var arguments = type.IsGenericType ? "<" + string.Join(", ", type.GetGenericArguments().Select(Of)) + ">" : "";
        return $"{outer}.{name}{arguments}";
    }
}
