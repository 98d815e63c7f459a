namespace UnityEngine.XR.Interaction.Toolkit;

public class SelectEnterEventArgs
{
}
