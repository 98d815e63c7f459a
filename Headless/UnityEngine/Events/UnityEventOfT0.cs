using System;

namespace UnityEngine.Events;

[Serializable]
public class UnityEvent<T0> : UnityEventBase
{
    static readonly Type[] Types = { typeof(T0) };

    UnityAction<T0> _listeners;

    internal override int ListenerCount => Host.Count(_listeners);

    public void AddListener(UnityAction<T0> call) => _listeners += call;

    public void RemoveListener(UnityAction<T0> call) => _listeners -= call;

    public void Invoke(T0 arg0)
    {
        if (GetPersistentEventCount() > 0) InvokePersistent(Types, new object[] { arg0 });
        _listeners?.Invoke(arg0);
    }

    internal override void ForgetListeners() => _listeners = null;
}
