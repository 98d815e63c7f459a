namespace UnityEngine.InputSystem;

[Serializable]
public sealed class InputAction : IDisposable
{
    readonly List<string> _paths = new List<string>();
    readonly InputActionType _type;
    int _enabledAt;

    public InputAction(
        string name = null, InputActionType type = default, string binding = null, string interactions = null, string processors = null,
        string expectedControlType = null)
    {
        _type = type;
        if (!string.IsNullOrEmpty(binding)) _paths.Add(binding);
    }

    public bool enabled { get; private set; }

    /// <summary>Whether a connected device has one of the bound controls.</summary>
    internal bool HasControl => _paths.Exists(path => Controls.TryGet(path, out _, out _));

    internal void Bind(string path) => _paths.Add(path);

    public void Enable()
    {
        enabled = true;
        _enabledAt = Time.frameCount;
    }

    public void Disable() => enabled = false;

    public void Dispose() => Disable();

    public bool IsPressed() => Find<bool>(out _);

    public bool WasPressedThisFrame() => Find<bool>(out var since) && since == Time.frameCount;

    public TValue ReadValue<TValue>() where TValue : struct => Find<TValue>(out _);

    TValue Find<TValue>(out int since) where TValue : struct
    {
        since = -1;
        if (!enabled) return default;
        foreach (var path in _paths)
        {
            if (!Controls.TryGet(path, out var value, out since) || !IsSeen(since)) continue;
            if (value is TValue found && !found.Equals(default(TValue))) return found;
        }
        return default;
    }

    // An action for a button does not see a button that was already pressed when the action was enabled.
    bool IsSeen(int since) => _type != InputActionType.Button || since > _enabledAt;
}

public enum InputActionType
{
    Value,
    Button,
    PassThrough,
}

[Serializable]
public struct InputActionProperty
{
    public InputActionProperty(InputAction action) => this.action = action;

    public InputAction action { get; }
}

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
