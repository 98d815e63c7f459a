using System.Reflection;
using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Fills in serialised fields by name, as the Inspector does.</summary>
static class Fields
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    /// <exception cref="ArgumentException">The class has no such serialised field, or it is of another type.</exception>
    public static void Set(object target, string name, object value)
    {
        for (var type = target.GetType(); type != null; type = type.BaseType)
        {
            var field = type.GetField(name, Declared);
            if (field == null) continue;
            if (!field.IsPublic && !field.IsDefined(typeof(SerializeField)))
                throw new ArgumentException($"{type.Name}.{name} is not serialised", nameof(name));
            field.SetValue(target, value);
            return;
        }
        throw new ArgumentException($"{target.GetType().Name} has no field {name}", nameof(name));
    }
}
