using UnityEngine.Serialization;

namespace UnityEngine.Events;

[Serializable]
public abstract class UnityEventBase : ISerializationCallbackReceiver
{
    [SerializeField, SerializedName("m_PersistentCalls")] PersistentCallGroup _persistent = new();

    internal PersistentCallGroup Persistent => _persistent;

    /// <summary>Types of the event's arguments.</summary>
    internal virtual Type[] ArgumentTypes => Type.EmptyTypes;

    public int GetPersistentEventCount() => _persistent.Calls.Count;
    public Object GetPersistentTarget(int index) => _persistent.Calls[index].Target;
    public string GetPersistentMethodName(int index) => _persistent.Calls[index].MethodName;
    public UnityEventCallState GetPersistentListenerState(int index) => _persistent.Calls[index].State;

    void ISerializationCallbackReceiver.OnBeforeSerialize() { }

    void ISerializationCallbackReceiver.OnAfterDeserialize() { }
}
