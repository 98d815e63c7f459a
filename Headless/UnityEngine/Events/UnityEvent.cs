using System;

namespace UnityEngine.Events;

[Serializable]
public class UnityEvent : UnityEventBase
{
    UnityAction _listeners;

    internal override int ListenerCount => Host.Count(_listeners);

    public void AddListener(UnityAction call) => _listeners += call;

    public void RemoveListener(UnityAction call) => _listeners -= call;

    public void Invoke()
    {
        InvokePersistent(Type.EmptyTypes, null);
        _listeners?.Invoke();
    }

    internal override void ForgetListeners() => _listeners = null;
}
