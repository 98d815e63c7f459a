using UnityEngine.Serialization;

namespace UnityEngine.Events;

/// <summary>Serialised argument of a persistent call of an event.</summary>
[Serializable]
sealed class PersistentArguments
{
    [SerializeField, SerializedName("m_ObjectArgument")] Object _object;
    [SerializeField, SerializedName("m_ObjectArgumentAssemblyTypeName")] string _objectType = "";
    [SerializeField, SerializedName("m_IntArgument")] int _int;
    [SerializeField, SerializedName("m_FloatArgument")] float _float;
    [SerializeField, SerializedName("m_StringArgument")] string _string = "";
    [SerializeField, SerializedName("m_BoolArgument")] bool _bool;

    internal static PersistentArguments Of(PersistentListenerMode mode, object value)
    {
        // The editor writes this type even if the argument is not an object.
        var made = new PersistentArguments { _objectType = "UnityEngine.Object, UnityEngine" };
        if (mode == PersistentListenerMode.Bool) made._bool = (bool)value;
        else if (mode == PersistentListenerMode.Float) made._float = (float)value;
        else if (value != null) throw new ArgumentException($"the stand-in does not support arguments of mode {mode}", nameof(mode));
        return made;
    }

    internal Type ObjectType => Type.GetType(_objectType) ?? typeof(Object);

    internal Type TypeFor(PersistentListenerMode mode) => mode switch
    {
        PersistentListenerMode.Object => ObjectType,
        PersistentListenerMode.Int => typeof(int),
        PersistentListenerMode.Float => typeof(float),
        PersistentListenerMode.String => typeof(string),
        PersistentListenerMode.Bool => typeof(bool),
        _ => null,
    };

    internal object ValueFor(PersistentListenerMode mode) => mode switch
    {
        PersistentListenerMode.Object => _object,
        PersistentListenerMode.Int => _int,
        PersistentListenerMode.Float => _float,
        PersistentListenerMode.String => _string,
        PersistentListenerMode.Bool => _bool,
        _ => null,
    };
}
