using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.XR;

namespace Nowpose.Samples
{
    /// <summary>Makes the camera follow the head. Adds the Input System's Tracked Pose Driver if the object does not have one.</summary>
    [AddComponentMenu("Nowpose/Samples/Head Tracking")]
    [RequireComponent(typeof(Camera))]
    [DisallowMultipleComponent]
    public sealed class HeadTracking : MonoBehaviour
    {
        const string Head = "<XRHMD>/centerEye";

        void OnEnable()
        {
            if (GetComponent<TrackedPoseDriver>() != null) return;
            var driver = gameObject.AddComponent<TrackedPoseDriver>();
            driver.positionInput = new InputActionProperty(new InputAction(binding: Head + "Position", expectedControlType: "Vector3"));
            driver.rotationInput = new InputActionProperty(new InputAction(binding: Head + "Rotation", expectedControlType: "Quaternion"));
        }
    }
}
