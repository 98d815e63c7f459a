using System;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.InputSystem;

namespace Nowpose.Samples
{
    /// <summary>Raises an event when the user presses a button of a controller or a key.</summary>
    [AddComponentMenu("Nowpose/Samples/Pressed Action")]
    public sealed class PressedAction : MonoBehaviour
    {
        [SerializeField, Tooltip("Paths in the Input System, for example <XRController>{RightHand}/{PrimaryButton} or <Keyboard>/g. Each of them "
            + "triggers the action.")]
        string[] _bindings = Array.Empty<string>();

        [SerializeField, Tooltip("Called once for each press.")]
        UnityEvent _onPressed = new UnityEvent();

        InputAction _action;

        void OnEnable()
        {
            _action = new InputAction(type: InputActionType.Button);
            foreach (var binding in _bindings) _action.AddBinding(binding);
            _action.Enable();
        }

        void OnDisable()
        {
            _action.Dispose();
            _action = null;
        }

        void Update()
        {
            if (_action.WasPressedThisFrame()) _onPressed.Invoke();
        }
    }
}
