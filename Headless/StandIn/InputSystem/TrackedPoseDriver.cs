namespace UnityEngine.InputSystem.XR;

/// <summary>Moves the transform to the pose of a device, relative to the parent. Without a device, the transform does not move.</summary>
/// <remarks>
/// Behaves like that of version 1.14.0: without an action for the tracking state, it never moves if the device is missing in the first frame.
/// </remarks>
[Serializable]
public class TrackedPoseDriver : MonoBehaviour
{
    const int Position = 1, Rotation = 2;

    InputActionProperty _position, _rotation, _trackingState;
    bool? _hadDevice;

    public InputActionProperty positionInput
    {
        get => _position;
        set => Bind(ref _position, value);
    }

    public InputActionProperty rotationInput
    {
        get => _rotation;
        set => Bind(ref _rotation, value);
    }

    public InputActionProperty trackingStateInput
    {
        get => _trackingState;
        set => Bind(ref _trackingState, value);
    }

    void Update()
    {
        if (_position.action == null || _rotation.action == null) return;
        _hadDevice ??= _position.action.HasControl && _rotation.action.HasControl;
        if (_trackingState.action == null && !_hadDevice.Value) return;
        var rotation = _rotation.action.ReadValue<Quaternion>();
        if (rotation == default) return;
        if (IsTracked(Position)) transform.localPosition = _position.action.ReadValue<Vector3>();
        if (IsTracked(Rotation)) transform.localRotation = rotation;
    }

    // A device that does not report its tracking state counts as tracked.
    bool IsTracked(int part) => _trackingState.action?.HasControl != true || (_trackingState.action.ReadValue<int>() & part) != 0;

    static void Bind(ref InputActionProperty bound, InputActionProperty value)
    {
        bound.action?.Disable();
        bound = value;
        bound.action?.Enable();
    }
}
