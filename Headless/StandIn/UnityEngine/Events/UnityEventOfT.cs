namespace UnityEngine.Events;

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    static readonly Type[] Types = { typeof(T0) };
    UnityAction<T0> _listeners;

    public void AddListener(UnityAction<T0> call) => _listeners += call;

    public void RemoveListener(UnityAction<T0> call) => _listeners -= call;

    /// <summary>
    /// Invokes the persistent calls first, then the listeners that code has added. A persistent call passes its serialised argument or this argument,
    /// depending on its mode.
    /// </summary>
    public void Invoke(T0 arg0)
    {
        // Iterates by index, because a listener may change the list.
        for (var i = 0; i < Persistent.Calls.Count; i++) Persistent.Calls[i].Invoke(Types, arg0);
        _listeners?.Invoke(arg0);
    }

    internal override Type[] ArgumentTypes => Types;
}

public delegate void UnityAction<T0>(T0 arg0);

[Serializable]
public class UnityEvent<T0, T1> : UnityEventBase
{
    static readonly Type[] Types = { typeof(T0), typeof(T1) };

    /// <inheritdoc cref="UnityEvent{T0}.Invoke"/>
    public void Invoke(T0 arg0, T1 arg1)
    {
        // Iterates by index, because a listener may change the list.
        for (var i = 0; i < Persistent.Calls.Count; i++) Persistent.Calls[i].Invoke(Types, arg0, arg1);
    }

    internal override Type[] ArgumentTypes => Types;
}
