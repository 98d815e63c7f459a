namespace UnityEngine.InputSystem;

[Serializable]
public struct InputActionProperty
{
    public InputActionProperty(InputAction action) => this.action = action;

    public InputAction action { get; }
}
