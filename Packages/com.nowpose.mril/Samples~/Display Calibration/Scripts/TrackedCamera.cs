using UnityEngine;
#if NOWPOSE_INPUT_SYSTEM
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.XR;
#endif

namespace Nowpose.Samples
{
    /// <summary>Makes the camera follow the headset. Without a headset, or without Input System 1.5 or newer, the camera stays in place.</summary>
    [AddComponentMenu("Nowpose/Samples/Tracked Camera")]
    [RequireComponent(typeof(Camera))]
    [DisallowMultipleComponent]
    public sealed class TrackedCamera : MonoBehaviour
    {
#if NOWPOSE_INPUT_SYSTEM
        void OnEnable()
        {
            if (GetComponent<TrackedPoseDriver>() != null) return;
            var driver = gameObject.AddComponent<TrackedPoseDriver>();
            driver.positionInput = new InputActionProperty(new InputAction(binding: "<XRHMD>/centerEyePosition", expectedControlType: "Vector3"));
            driver.rotationInput = new InputActionProperty(new InputAction(binding: "<XRHMD>/centerEyeRotation", expectedControlType: "Quaternion"));
            // Without it, version 1.14.0 of the driver never moves the camera if the headset starts after the scene.
            driver.trackingStateInput = new InputActionProperty(new InputAction(binding: "<XRHMD>/trackingState", expectedControlType: "Integer"));
        }
#else
        void OnEnable()
        {
            if (!Application.isEditor)
                Debug.LogWarning(
                    "[Nowpose] the camera does not follow the headset: install com.unity.inputsystem 1.5 or newer", this);
        }
#endif
    }
}
