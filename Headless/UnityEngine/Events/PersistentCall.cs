using System;
using System.Reflection;
using System.Runtime.ExceptionServices;
using UnityEngine.Serialization;

namespace UnityEngine.Events;

/// <summary>A call that an event keeps in its file: an object, a method, an argument.</summary>
[Serializable]
sealed class PersistentCall
{
    const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static;

    [SerializeField, SerializedName("m_Target")] Object _target;
    [SerializeField, SerializedName("m_TargetAssemblyTypeName")] string _targetType = "";
    [SerializeField, SerializedName("m_MethodName")] string _method = "";
    [SerializeField, SerializedName("m_Mode")] PersistentListenerMode _mode = PersistentListenerMode.EventDefined;
    [SerializeField, SerializedName("m_Arguments")] PersistentArguments _arguments = new();
    [SerializeField, SerializedName("m_CallState")] UnityEventCallState _state = UnityEventCallState.RuntimeOnly;

    internal Object Target => _target;
    internal string MethodName => _method;

    /// <summary>Calls it, with the argument that is kept.</summary>
    internal void Invoke()
    {
        if (_state == UnityEventCallState.Off || (_state == UnityEventCallState.RuntimeOnly && !Application.isPlaying)) return;
        if (_target == null || _method.Length == 0) return;

        var method = Method();
        if (method == null)
        {
            Debug.LogError($"The event calls {_target.GetType().Name}.{_method}, which does not exist with such an argument.", _target);
            return;
        }

        var arguments = TakesArgument ? new[] { _arguments.ValueFor(_mode) } : null;
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

    // The event has no argument of its own to pass on.
    bool TakesArgument => _mode != PersistentListenerMode.EventDefined && _mode != PersistentListenerMode.Void;

    /// <summary>Null where there is none of that name for the argument.</summary>
    internal MethodInfo Method()
    {
        var types = TakesArgument ? new[] { _arguments.TypeFor(_mode) } : Type.EmptyTypes;
        for (var type = _target.GetType(); type != null && type != typeof(object); type = type.BaseType)
        {
            var method = type.GetMethod(_method, Any, null, types, null);
            if (method != null) return method;
        }

        return null;
    }
}
