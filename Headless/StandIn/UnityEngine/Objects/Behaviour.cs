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

    public bool isActiveAndEnabled => !Destroyed && _enabled && Owner is { activeInHierarchy: true };

    /// <summary>Whether the behaviour is enabled on an active object and has received OnEnable.</summary>
    internal bool Running { get; private set; }

    internal override void Activated() => UpdateRunning();

    internal override void Deactivated() => UpdateRunning();

    /// <summary>Whether the behaviour may run. A script may run only after Awake.</summary>
    internal virtual bool MayRun => true;

    internal virtual void StartRunning() { }

    internal virtual void StopRunning() { }

    internal void UpdateRunning() => SetRunning(isActiveAndEnabled && MayRun);

    internal void SetRunning(bool running)
    {
        if (Running == running) return;

        Running = running;
        if (running) StartRunning();
        else StopRunning();
    }
}
