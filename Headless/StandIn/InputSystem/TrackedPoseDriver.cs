namespace UnityEngine.InputSystem.XR;

/// <summary>Moves the transform to the pose of a device, relative to the parent. Without a device, the transform does not move.</summary>
[Serializable]
public class TrackedPoseDriver : MonoBehaviour
{
    InputActionProperty _position, _rotation;

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

    void Update()
    {
        if (_position.action == null || _rotation.action == null) return;
        var rotation = _rotation.action.ReadValue<Quaternion>();
        if (rotation == default) return;
        transform.localPosition = _position.action.ReadValue<Vector3>();
        transform.localRotation = rotation;
    }

    static void Bind(ref InputActionProperty bound, InputActionProperty value)
    {
        bound.action?.Disable();
        bound = value;
        bound.action?.Enable();
    }
}
