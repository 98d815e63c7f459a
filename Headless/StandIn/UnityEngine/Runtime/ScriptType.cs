using System.Collections;
using System.Collections.Concurrent;
using System.Reflection;

namespace UnityEngine;

/// <summary>Metadata of a script class: messages, execution order and requirements.</summary>
sealed class ScriptType
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    // Messages of Unity that the stand-in does not support. A script with one of them is rejected, because it would behave differently.
    static readonly string[] NotCalled =
    {
        "FixedUpdate", "OnGUI", "OnBecameVisible", "OnBecameInvisible", "OnWillRenderObject", "OnRenderObject", "OnRenderImage",
        "OnPreCull", "OnPreRender", "OnPostRender", "OnTransformChildrenChanged",
        "OnBeforeTransformParentChanged",
    };

    static readonly ConcurrentDictionary<Type, ScriptType> Known = new();

    readonly MessageCall[] _messages = new MessageCall[(int)Message.Count];
    readonly Func<MonoBehaviour, IEnumerator> _startRoutine;
    readonly MessageCall _start;

    ScriptType(Type type)
    {
        Order = type.GetCustomAttribute<DefaultExecutionOrder>(true)?.order ?? 0;
        RunsInEditMode = type.IsDefined(typeof(ExecuteAlways), true);
        foreach (var message in NotCalled)
        {
            if (Method(type, message) != null) throw new NotSupportedException($"{type.Name}.{message}: the stand-in does not call that message");
        }

        for (var i = 0; i < _messages.Length; i++) _messages[i] = MessageCall.To(type, Method(type, ((Message)i).ToString()));

        var start = Method(type, "Start");
        if (start?.ReturnType == typeof(IEnumerator)) _startRoutine = script => (IEnumerator)start.Invoke(script, null);
        else _start = MessageCall.To(type, start);
    }

    /// <summary>Execution order. Scripts with lower numbers run earlier.</summary>
    internal int Order { get; }

    internal bool RunsInEditMode { get; }

    internal static ScriptType Of(Type type) => Known.GetOrAdd(type, t => new ScriptType(t));

    internal bool Has(Message message) => _messages[(int)message] != null;

    /// <summary>Calls a message. As in Unity, an exception is logged with the script as context. Returns false in this case.</summary>
    internal bool Call(Message message, MonoBehaviour script) => Guard(_messages[(int)message], script);

    internal void Start(MonoBehaviour script)
    {
        if (_startRoutine != null) script.StartCoroutine(_startRoutine(script));
        else Guard(_start, script);
    }

    static bool Guard(MessageCall call, MonoBehaviour script)
    {
        try
        {
            call?.Invoke(script);
            return true;
        }
        catch (Exception e)
        {
            Debug.LogException(e, script);
            return false;
        }
    }

    /// <summary>Finds a message in a class of scripts or ScriptableObjects or its base classes; null if there is none.</summary>
    internal static MethodInfo Method(Type type, string name, params Type[] parameters)
    {
        for (var t = type; t != null && t != typeof(MonoBehaviour) && t != typeof(ScriptableObject); t = t.BaseType)
        {
            var method = t.GetMethod(name, Declared, null, parameters, null);
            if (method != null) return method;
        }

        return null;
    }
}
