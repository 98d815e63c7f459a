namespace UnityEngine.Events;

[Serializable]
public class UnityEvent : UnityEventBase
{
    UnityAction _listeners;

    public void AddListener(UnityAction call) => _listeners += call;

    public void RemoveListener(UnityAction call) => _listeners -= call;

    /// <summary>Invokes the persistent calls first, then the listeners that code has added.</summary>
    public void Invoke()
    {
        // Iterates by index, because a listener may change the list.
        for (var i = 0; i < Persistent.Calls.Count; i++) Persistent.Calls[i].Invoke(Type.EmptyTypes);
        _listeners?.Invoke();
    }
}

public delegate void UnityAction();
