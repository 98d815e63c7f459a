namespace UnityEngine.XR.Interaction.Toolkit;

/// <summary>What interactors hold. Here tests do: <see cref="Enter"/> and <see cref="Exit"/> stand for any hand, pinch or ray.</summary>
public abstract class XRBaseInteractable : MonoBehaviour
{
    int _selecting;

    public SelectEnterEvent firstSelectEntered { get; set; } = new();
    public SelectExitEvent lastSelectExited { get; set; } = new();

    public bool isSelected => _selecting > 0;

    protected virtual void Awake() { }

    /// <summary>What is not active is not registered with the manager: nobody reaches it.</summary>
    internal void Enter()
    {
        if (isActiveAndEnabled && _selecting++ == 0) firstSelectEntered.Invoke(new SelectEnterEventArgs());
    }

    internal void Exit()
    {
        if (_selecting > 0 && --_selecting == 0) lastSelectExited.Invoke(new SelectExitEventArgs());
    }
}
