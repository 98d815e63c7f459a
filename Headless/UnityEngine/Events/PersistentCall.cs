using System;
using System.Reflection;
using System.Runtime.ExceptionServices;
using UnityEngine.Serialization;

namespace UnityEngine.Events;

/// <summary>A call that an event keeps in its file: an object, a method, an argument.</summary>
[Serializable]
sealed class PersistentCall
{
    [SerializeField, SerializedName("m_Target")] Object _target;
    [SerializeField, SerializedName("m_TargetAssemblyTypeName")] string _targetType = "";
    [SerializeField, SerializedName("m_MethodName")] string _method = "";
    [SerializeField, SerializedName("m_Mode")] PersistentListenerMode _mode = PersistentListenerMode.EventDefined;
    [SerializeField, SerializedName("m_Arguments")] PersistentArguments _arguments = new();
    [SerializeField, SerializedName("m_CallState")] UnityEventCallState _state = UnityEventCallState.RuntimeOnly;

    internal Object Target => _target;
    internal string MethodName => _method;

    /// <summary>Calls it with the event's own arguments or with the one kept.</summary>
    internal void Invoke(Type[] eventTypes, object[] eventArguments)
    {
        if (_state == UnityEventCallState.Off || (_state == UnityEventCallState.RuntimeOnly && !Application.isPlaying)) return;
        if (_target == null || _method.Length == 0) return;

        var method = Method(eventTypes);
        if (method == null)
        {
            Debug.LogError($"The event calls {_target.GetType().Name}.{_method}, which does not exist with such an argument.", _target);
            return;
        }

        var arguments = _mode switch
        {
            PersistentListenerMode.EventDefined => eventArguments,
            PersistentListenerMode.Void => null,
            _ => new[] { _arguments.ValueFor(_mode) },
        };
        try
        {
            method.Invoke(_target, arguments);
        }
        catch (TargetInvocationException e)
        {
            // The caller of Invoke gets what the listener threw, as from a delegate.
            ExceptionDispatchInfo.Capture(e.InnerException).Throw();
        }
    }

    /// <summary>Null where there is none of that name for these arguments.</summary>
    internal MethodInfo Method(Type[] eventTypes) => UnityEventBase.GetValidMethodInfo(_target, _method, _mode switch
    {
        PersistentListenerMode.EventDefined => eventTypes,
        PersistentListenerMode.Void => Type.EmptyTypes,
        _ => new[] { _arguments.TypeFor(_mode) },
    });
}
