using UnityEngine;
#if NOWPOSE_INPUT_SYSTEM
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.XR;
#endif

namespace Nowpose.Samples
{
    /// <summary>Makes the camera follow the headset. Without a headset, or without the Input System, the camera stays in place.</summary>
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
        }
#else
        void OnEnable()
        {
            if (!Application.isEditor)
                Debug.LogWarning(
                    "[Nowpose] the camera does not follow the headset: install com.unity.inputsystem, or com.unity.xr.openxr, which needs it", this);
        }
#endif
    }
}
