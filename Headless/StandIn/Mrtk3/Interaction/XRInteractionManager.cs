namespace UnityEngine.XR.Interaction.Toolkit;

/// <summary>Lists the interactables for the interactors. The stand-in has no interactors, so it keeps no list.</summary>
sealed class XRInteractionManager
{
    public void RegisterInteractable(XRBaseInteractable interactable) { }

    public void UnregisterInteractable(XRBaseInteractable interactable) { }
}
