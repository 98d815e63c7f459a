using UnityEngine.Events;

namespace UnityEngine.XR.Interaction.Toolkit;

[Serializable]
public sealed class SelectExitEvent : UnityEvent<SelectExitEventArgs>
{
}

public class SelectExitEventArgs
{
}
