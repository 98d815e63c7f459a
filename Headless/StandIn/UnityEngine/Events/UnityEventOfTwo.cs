namespace UnityEngine.Events;

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
