namespace UnityEngine.InputSystem;

public static class InputActionSetupExtensions
{
    public static BindingSyntax AddBinding(
        this InputAction action, string path, string interactions = null, string processors = null, string groups = null)
    {
        action.Bind(path);
        return default;
    }

    public struct BindingSyntax { }
}
