namespace UnityEngine.Serialization;

/// <summary>Name of a field in Unity's files, for fields of Unity's own classes.</summary>
[AttributeUsage(AttributeTargets.Field)]
sealed class SerializedNameAttribute : Attribute
{
    internal SerializedNameAttribute(string name) => Name = name;

    internal string Name { get; }
}
