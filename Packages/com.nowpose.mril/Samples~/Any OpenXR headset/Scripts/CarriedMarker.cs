using Nowpose.Unity;
using UnityEngine;
using UnityEngine.InputSystem;

namespace Nowpose.Samples
{
    /// <summary>Moves the marker of the robot's base with a controller while the grip button of the controller is pressed.</summary>
    /// <remarks>The marker keeps its pose relative to the controller, as an object in the hand does.</remarks>
    [AddComponentMenu("Nowpose/Samples/Carried Marker")]
    [RequireComponent(typeof(HandPlacedMarker))]
    [DisallowMultipleComponent]
    public sealed class CarriedMarker : MonoBehaviour
    {
        [SerializeField, Tooltip("Path of the controller in the Input System.")]
        string _controller = "<XRController>{RightHand}";

        [SerializeField, Tooltip("Path of the button that is held to carry the marker.")]
        string _grip = "<XRController>{RightHand}/{GripButton}";

        [SerializeField, Tooltip("The origin in which controllers are tracked, which is the parent of the camera. Empty: the world's origin.")]
        Transform _trackingOrigin = null;

        HandPlacedMarker _marker;
        InputAction _position, _rotation, _held;
        Vector3 _offset;
        Quaternion _turn;

        void OnEnable()
        {
            _marker = GetComponent<HandPlacedMarker>();
            _position = Enabled(new InputAction(binding: _controller + "/devicePosition", expectedControlType: "Vector3"));
            _rotation = Enabled(new InputAction(binding: _controller + "/deviceRotation", expectedControlType: "Quaternion"));
            _held = Enabled(new InputAction(type: InputActionType.Button, binding: _grip));
        }

        void OnDisable()
        {
            if (_marker.IsMoving) _marker.EndMove();
            _position.Dispose();
            _rotation.Dispose();
            _held.Dispose();
        }

        void Update()
        {
            if (_held.IsPressed()) Carry();
            else if (_marker.IsMoving) _marker.EndMove();
        }

        void Carry()
        {
            var hand = _position.ReadValue<Vector3>();
            var turned = _rotation.ReadValue<Quaternion>();
            // While the controller is not tracked, its rotation is a quaternion of zeros.
            if (Quaternion.Dot(turned, turned) < 0.5f) return;
            if (_trackingOrigin != null)
            {
                hand = _trackingOrigin.TransformPoint(hand);
                turned = _trackingOrigin.rotation * turned;
            }
            if (!_marker.IsMoving) Grab(hand, turned);
            transform.SetPositionAndRotation(hand + turned * _offset, turned * _turn);
        }

        void Grab(Vector3 hand, Quaternion turned)
        {
            _marker.BeginMove();
            var back = Quaternion.Inverse(turned);
            _offset = back * (transform.position - hand);
            _turn = back * transform.rotation;
        }

        static InputAction Enabled(InputAction action)
        {
            action.Enable();
            return action;
        }
    }
}
