using System.Reflection;
using System.Runtime.ExceptionServices;
using UnityEngine.Serialization;

namespace UnityEngine.Events;

/// <summary>A persistent call of an event, as Unity serialises it: a target object, a method and an argument.</summary>
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
    internal string TargetTypeName => _targetType;
    internal string MethodName => _method;
    internal PersistentListenerMode Mode => _mode;
    internal UnityEventCallState State { get => _state; set => _state = value; }

    /// <summary>Creates a call as the editor does.</summary>
    /// <param name="argument">Argument with the type that the mode requires; null if there is none.</param>
    internal static PersistentCall Of(Object target, string method, PersistentListenerMode mode, object argument)
    {
        var type = target.GetType();
        return new PersistentCall
        {
            _target = target,
            _targetType = type.FullName + ", " + type.Assembly.GetName().Name,
            _method = method,
            _mode = mode,
            _arguments = PersistentArguments.Of(mode, argument),
            _state = UnityEventCallState.RuntimeOnly,
        };
    }

    /// <summary>Invokes the method. The mode determines whether the argument is the serialised argument or the argument of the event.</summary>
    /// <param name="eventTypes">Types of the event's arguments.</param>
    /// <param name="eventArguments">The event's arguments.</param>
    internal void Invoke(Type[] eventTypes, params object[] eventArguments)
    {
        if (_state == UnityEventCallState.Off || (_state == UnityEventCallState.RuntimeOnly && !Application.isPlaying)) return;
        if (_target == null || _method.Length == 0) return;

        var method = Method(eventTypes);
        if (method == null)
        {
            Debug.LogError($"The event calls {_target.GetType().Name}.{_method}, which does not exist with such an argument.", _target);
            return;
        }

        var arguments = KeepsArgument ? new[] { _arguments.ValueFor(_mode) } : _mode == PersistentListenerMode.Void ? null : eventArguments;
        try
        {
            method.Invoke(_target, arguments);
        }
        catch (TargetInvocationException e)
        {
            // Throws the exception of the listener itself, as a delegate does.
            ExceptionDispatchInfo.Capture(e.InnerException).Throw();
        }
    }

    bool KeepsArgument => _mode != PersistentListenerMode.EventDefined && _mode != PersistentListenerMode.Void;

    Type[] ArgumentTypes(Type[] eventTypes)
    {
        if (_mode == PersistentListenerMode.EventDefined) return eventTypes;
        return KeepsArgument ? new[] { _arguments.TypeFor(_mode) } : Type.EmptyTypes;
    }

    /// <summary>Returns the method; null if the target has no method with this name and these arguments.</summary>
    /// <param name="eventTypes">Types of the event's arguments.</param>
    internal MethodInfo Method(Type[] eventTypes)
    {
        var types = ArgumentTypes(eventTypes);
        for (var type = _target.GetType(); type != null && type != typeof(object); type = type.BaseType)
        {
            var method = type.GetMethod(_method, Any, null, types, null);
            if (method != null) return method;
        }

        return null;
    }
}

/// <summary>The persistent calls of an event, as Unity serialises them.</summary>
[Serializable]
sealed class PersistentCallGroup
{
    [SerializeField, SerializedName("m_Calls")] List<PersistentCall> _calls = new();

    internal IReadOnlyList<PersistentCall> Calls => _calls;

    internal void Add(PersistentCall call) => _calls.Add(call);
}

/// <summary>Kind of argument of a persistent call.</summary>
enum PersistentListenerMode
{
    EventDefined,
    Void,
    Object,
    Int,
    Float,
    String,
    Bool,
}

public enum UnityEventCallState
{
    Off = 0,
    EditorAndRuntime = 1,
    RuntimeOnly = 2,
}
