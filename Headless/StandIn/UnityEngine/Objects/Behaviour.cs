using UnityEngine.Serialization;

namespace UnityEngine;

public class Behaviour : Component
{
    [SerializeField, SerializedName("m_Enabled")] bool _enabled = true;

    public bool enabled
    {
        get
        {
            ThrowIfDestroyed();
            return _enabled;
        }
        set
        {
            ThrowIfDestroyed();
            if (_enabled == value) return;

            _enabled = value;
            UpdateRunning();
        }
    }

    /// <summary>
    /// False until OnEnable, although the object may already be active: each component of a hierarchy is activated in its turn. In edit mode, also true
    /// for a script that does not run there.
    /// </summary>
    public bool isActiveAndEnabled => IsRunInTurn ? Running : IsToRun;

    bool IsToRun => !Destroyed && _enabled && Owner is { activeInHierarchy: true };

    /// <summary>Whether the behaviour is enabled on an active object and has received OnEnable.</summary>
    internal bool Running { get; private set; }

    internal override void Activated() => UpdateRunning();

    internal override void Deactivated() => UpdateRunning();

    /// <summary>Whether the behaviour receives OnEnable when its object is activated.</summary>
    internal virtual bool IsRunInTurn => true;

    /// <summary>Whether the behaviour may run. A script may run only after Awake.</summary>
    internal virtual bool MayRun => true;

    internal virtual void StartRunning() { }

    internal virtual void StopRunning() { }

    internal void UpdateRunning() => SetRunning(IsToRun && MayRun);

    internal void SetRunning(bool running)
    {
        if (Running == running) return;

        Running = running;
        if (running) StartRunning();
        else StopRunning();
    }
}
