namespace UnityEngine.XR.Interaction.Toolkit;

/// <summary>An object that interactors can hold. The stand-in has no interactors: tests call <see cref="Enter"/> and <see cref="Exit"/>.</summary>
public abstract class XRBaseInteractable : MonoBehaviour
{
    int _selecting;

    public SelectEnterEvent firstSelectEntered { get; set; } = new();
    public SelectExitEvent lastSelectExited { get; set; } = new();

    /// <summary>The manager; null before the object is first active.</summary>
    internal XRInteractionManager interactionManager { get; set; }

    protected virtual void Awake() => interactionManager ??= new XRInteractionManager();

    /// <summary>Simulates an interactor that takes hold of the object. Does nothing if the object is inactive, as in Unity.</summary>
    internal void Enter()
    {
        if (isActiveAndEnabled && _selecting++ == 0) firstSelectEntered.Invoke(new SelectEnterEventArgs());
    }

    internal void Exit()
    {
        if (_selecting > 0 && --_selecting == 0) lastSelectExited.Invoke(new SelectExitEventArgs());
    }
}
