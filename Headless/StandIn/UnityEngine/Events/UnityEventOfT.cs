using System;

namespace UnityEngine.Events;

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    UnityAction<T0> _listeners;

    public void AddListener(UnityAction<T0> call) => _listeners += call;

    public void RemoveListener(UnityAction<T0> call) => _listeners -= call;

    /// <summary>Those of the file first, then those added by code; a call of the file either has an argument of its own or takes this one.</summary>
    public void Invoke(T0 arg0)
    {
        // An index: a listener may change the list.
        for (var i = 0; i < Persistent.Calls.Count; i++) Persistent.Calls[i].Invoke(typeof(T0), arg0);
        _listeners?.Invoke(arg0);
    }

    internal override Type ArgumentType => typeof(T0);
}
