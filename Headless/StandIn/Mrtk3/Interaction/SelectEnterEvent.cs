using UnityEngine.Events;

namespace UnityEngine.XR.Interaction.Toolkit;

[Serializable]
public sealed class SelectEnterEvent : UnityEvent<SelectEnterEventArgs>
{
}

public class SelectEnterEventArgs
{
}
