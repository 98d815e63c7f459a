using System;
using System.Reflection;
using UnityEngine.Serialization;

namespace UnityEngine.Events;

[Serializable]
public abstract class UnityEventBase : ISerializationCallbackReceiver
{
    const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static;

    [SerializeField, SerializedName("m_PersistentCalls")] PersistentCallGroup _persistent = new();

    internal PersistentCallGroup Persistent => _persistent;

    /// <summary>Delegates added by code.</summary>
    internal abstract int ListenerCount { get; }

    public int GetPersistentEventCount() => _persistent.Calls.Count;
    public Object GetPersistentTarget(int index) => _persistent.Calls[index].Target;
    public string GetPersistentMethodName(int index) => _persistent.Calls[index].MethodName;

    /// <summary>Those added by code; what the file keeps stays.</summary>
    public void RemoveAllListeners() => ForgetListeners();

    public static MethodInfo GetValidMethodInfo(object obj, string functionName, Type[] argumentTypes)
    {
        for (var type = obj.GetType(); type != null && type != typeof(object); type = type.BaseType)
        {
            var method = type.GetMethod(functionName, Any, null, argumentTypes, null);
            if (method != null) return method;
        }

        return null;
    }

    void ISerializationCallbackReceiver.OnBeforeSerialize() { }

    void ISerializationCallbackReceiver.OnAfterDeserialize() { }

    internal abstract void ForgetListeners();

    internal void InvokePersistent(Type[] types, object[] arguments)
    {
        // An index: a listener may change the list, and nothing is allocated.
        for (var i = 0; i < _persistent.Calls.Count; i++) _persistent.Calls[i].Invoke(types, arguments);
    }
}
