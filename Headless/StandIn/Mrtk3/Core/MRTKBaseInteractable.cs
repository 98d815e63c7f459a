using UnityEngine.XR.Interaction.Toolkit;

namespace MixedReality.Toolkit;

public class MRTKBaseInteractable : XRBaseInteractable
{
}
