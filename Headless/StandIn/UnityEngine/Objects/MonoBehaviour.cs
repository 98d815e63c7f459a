using System.Collections;

namespace UnityEngine;

public class MonoBehaviour : Behaviour
{
    bool _awake;
    bool _started;

    internal bool Awoken => _awake;

    internal ScriptType Script => field ??= ScriptType.Of(GetType());

    internal override bool IsRunInTurn => World.RunsScript(Script);

    internal override bool MayRun => _awake;

    public Coroutine StartCoroutine(IEnumerator routine)
    {
        ThrowIfDestroyed();
        if (gameObject.activeInHierarchy) return World.Coroutines.Start(this, routine);

        Debug.LogError($"Coroutine couldn't be started because the the game object '{name}' is inactive!", this);
        return null;
    }

    public void StopCoroutine(Coroutine routine) => World.Coroutines.Stop(this, routine);

    /// <summary>Calls Start if it has not been called yet. This happens before the first frame message of the script.</summary>
    internal void EnsureStarted()
    {
        if (_started) return;

        _started = true;
        Script.Start(this);
    }

    internal override void Activated()
    {
        if (!_awake && World.RunsScript(Script))
        {
            _awake = true;
            // As in Unity, a script is disabled if its Awake throws.
            if (!Script.Call(Message.Awake, this)) enabled = false;
        }

        if (!Destroyed) base.Activated();
    }

    internal override void Deactivated()
    {
        base.Deactivated();
        World.Coroutines.StopAll(this);
    }

    internal override void StartRunning()
    {
        World.Scripts.Add(this, !_started);
        Script.Call(Message.OnEnable, this);
    }

    internal override void StopRunning()
    {
        Script.Call(Message.OnDisable, this);
        World.Scripts.Remove(this);
    }

    internal override void Destroying()
    {
        if (_awake) Script.Call(Message.OnDestroy, this);
        World.Coroutines.StopAll(this);
    }
}
