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
}
