using System;

namespace UnityEngine.Serialization;

/// <summary>The name that Unity's files have for a field of the engine's own classes.</summary>
[AttributeUsage(AttributeTargets.Field)]
sealed class SerializedNameAttribute : Attribute
{
    internal SerializedNameAttribute(string name) => Name = name;

    internal string Name { get; }
}
