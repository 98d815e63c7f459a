using Nowpose.Anchoring;
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

        [SerializeField, Tooltip("The base that the marker places. Empty: the marker can be carried from any distance, even if the base is locked.")]
        BaseAnchor _anchor = null;

        [SerializeField, Range(0, 10), Tooltip("Maximum distance between the controller and the marker of a locked base when the button is pressed, "
            + "metres. Default 0.5: a hand that rests on the button does not move the base, and a hand beside the robot's foot reaches it.")]
        float _reachMetres = 0.5f;

        HandPlacedMarker _marker;
        InputAction _position, _rotation, _tracked, _held;
        Vector3 _offset;
        Quaternion _turn;

        void OnEnable()
        {
            _marker = GetComponent<HandPlacedMarker>();
            _position = Enabled(new InputAction(binding: _controller + "/devicePosition", expectedControlType: "Vector3"));
            _rotation = Enabled(new InputAction(binding: _controller + "/deviceRotation", expectedControlType: "Quaternion"));
            // Not an action of the type Button, which would not see that the controller is already tracked.
            _tracked = Enabled(new InputAction(binding: _controller + "/isTracked", expectedControlType: "Button"));
            _held = Enabled(new InputAction(type: InputActionType.Button, binding: _grip));
        }

        void OnDisable()
        {
            _marker.EndMove();
            _position.Dispose();
            _rotation.Dispose();
            _tracked.Dispose();
            _held.Dispose();
        }

        void Update()
        {
            if (!_held.IsPressed()) _marker.EndMove();
            // Otherwise the pose is an estimate, or at the origin.
            else if (_tracked.IsPressed()) Carry();
        }

        void Carry()
        {
            var hand = _position.ReadValue<Vector3>();
            var turned = _rotation.ReadValue<Quaternion>();
            if (_trackingOrigin != null)
            {
                hand = _trackingOrigin.TransformPoint(hand);
                turned = _trackingOrigin.rotation * turned;
            }
            if (_held.WasPressedThisFrame() && IsWithinReach(hand)) Grab(hand, turned);
            if (_marker.IsMoving) transform.SetPositionAndRotation(hand + turned * _offset, turned * _turn);
        }

        bool IsWithinReach(Vector3 hand) =>
            _anchor == null || _anchor.State != BaseAnchorState.Locked || Vector3.Distance(hand, transform.position) <= _reachMetres;

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
