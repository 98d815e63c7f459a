namespace UnityEngine;

/// <summary>The running scripts in execution order.</summary>
sealed class Scripts
{
    readonly ScriptList _starting = new();
    readonly ScriptList _updating = new();
    readonly ScriptList _lateUpdating = new();

    internal void Add(MonoBehaviour script, bool starts)
    {
        if (starts) _starting.Add(script);
        if (script.Script.Has(Message.Update)) _updating.Add(script);
        if (script.Script.Has(Message.LateUpdate)) _lateUpdating.Add(script);
    }

    internal void Remove(MonoBehaviour script)
    {
        _starting.Remove(script);
        _updating.Remove(script);
        _lateUpdating.Remove(script);
    }

    /// <summary>Calls Start on the running scripts that have not received it yet.</summary>
    internal void Start()
    {
        _starting.BeginPass();
        for (var i = 0; i < _starting.Size; i++)
        {
            var script = _starting[i];
            if (script is null) continue;

            _starting.Remove(script);
            script.EnsureStarted();
        }
    }

    internal void Update() => Pass(_updating, Message.Update);

    internal void LateUpdate() => Pass(_lateUpdating, Message.LateUpdate);

    static void Pass(ScriptList scripts, Message message)
    {
        scripts.BeginPass();
        for (var i = 0; i < scripts.Size; i++)
        {
            var script = scripts[i];
            script?.EnsureStarted();
            // The entry is empty if the script was destroyed or disabled in its Start.
            if (script is not null && ReferenceEquals(scripts[i], script)) script.Script.Call(message, script);
        }
    }
}
