namespace UnityEngine.XR.Interaction.Toolkit;

/// <summary>An object that interactors can hold. Here, tests call <see cref="Enter"/> and <see cref="Exit"/> for any hand, pinch or ray.</summary>
public abstract class XRBaseInteractable : MonoBehaviour
{
    int _selecting;

    public SelectEnterEvent firstSelectEntered { get; set; } = new();
    public SelectExitEvent lastSelectExited { get; set; } = new();

    public bool isSelected => _selecting > 0;

    protected virtual void Awake() { }

    /// <summary>Does nothing for an inactive object, which is not registered with the manager.</summary>
    internal void Enter()
    {
        if (isActiveAndEnabled && _selecting++ == 0) firstSelectEntered.Invoke(new SelectEnterEventArgs());
    }

    internal void Exit()
    {
        if (_selecting > 0 && --_selecting == 0) lastSelectExited.Invoke(new SelectExitEventArgs());
    }
}
