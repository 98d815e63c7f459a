using System.Reflection;

namespace Nowpose.Prefabs;

/// <summary>Sets serialised fields by name, as the Inspector does.</summary>
static class Fields
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    /// <exception cref="ArgumentException">The class has no serialised field of this name, or the field has another type.</exception>
    public static void Set(object target, string name, object value) => Of(target, name).SetValue(target, value);

    /// <inheritdoc cref="Set"/>
    public static T Get<T>(object target, string name)
    {
        return (T)Of(target, name).GetValue(target);
    }

    static FieldInfo Of(object target, string name)
    {
        for (var type = target.GetType(); type != null; type = type.BaseType)
        {
            var field = type.GetField(name, Declared);
            if (field == null) continue;
            return field.IsPublic || field.IsDefined(typeof(SerializeField))
                ? field
                : throw new ArgumentException($"{type.Name}.{name} is not serialised", nameof(name));
        }
        throw new ArgumentException($"{target.GetType().Name} has no field {name}", nameof(name));
    }
}
