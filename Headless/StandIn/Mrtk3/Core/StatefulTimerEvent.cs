using UnityEngine.Events;

namespace MixedReality.Toolkit;

[Serializable]
public class StatefulTimerEvent : UnityEvent<float>
{
}
