using System.Reflection;

namespace UnityEngine;

/// <summary>Requirements of a component class: other components, and whether a GameObject may have only one instance.</summary>
sealed class Requirements
{
    Requirements(Type type)
    {
        Alone = type.IsDefined(typeof(DisallowMultipleComponent), true);
        var types = new List<Type>();
        foreach (var attribute in type.GetCustomAttributes<RequireComponent>(true))
        {
            foreach (var required in new[] { attribute.m_Type0, attribute.m_Type1 })
            {
                if (required != null) types.Add(required);
            }
        }

        Types = types;
    }

    /// <summary>Whether a GameObject may have at most one component of this class.</summary>
    internal bool Alone { get; }

    internal IReadOnlyList<Type> Types { get; }

    internal static Requirements Of(Type type) => new(type);
}
