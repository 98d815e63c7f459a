using System;
using UnityEngine;

namespace MixedReality.Toolkit;

[Serializable]
public class TimedFlag
{
    [SerializeField] bool active;
    [SerializeField] StatefulTimerEvent onEntered = new();
    [SerializeField] StatefulTimerEvent onExited = new();

    public bool Active
    {
        get => active;
        internal set
        {
            if (value == active) return;
            active = value;
            (active ? onEntered : onExited).Invoke(Time.time);
        }
    }

    public StatefulTimerEvent OnEntered => onEntered;
    public StatefulTimerEvent OnExited => onExited;

    /// <summary>Sets the value without raising events.</summary>
    public void Initialize(bool value) => active = value;

    public static implicit operator bool(TimedFlag flag) => flag.Active;
}
