using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.XR;

namespace Nowpose.Samples
{
    /// <summary>
    /// Makes the camera follow the head, and moves its parent so that the head starts at height 0. Adds the Input System's Tracked Pose Driver if the
    /// object does not have one.
    /// </summary>
    /// <remarks>Headsets measure the height of the head from the floor or from its initial position, so the height of the base would differ.</remarks>
    [AddComponentMenu("Nowpose/Samples/Head Tracking")]
    [RequireComponent(typeof(Camera))]
    [DisallowMultipleComponent]
    public sealed class HeadTracking : MonoBehaviour
    {
        const string Head = "<XRHMD>/";

        bool _isLevel;

        void OnEnable()
        {
            if (GetComponent<TrackedPoseDriver>() != null) return;
            var driver = gameObject.AddComponent<TrackedPoseDriver>();
            driver.positionInput = new InputActionProperty(new InputAction(binding: Head + "centerEyePosition", expectedControlType: "Vector3"));
            driver.rotationInput = new InputActionProperty(new InputAction(binding: Head + "centerEyeRotation", expectedControlType: "Quaternion"));
            // Without it, version 1.14.0 of the driver never moves the camera if the headset starts after the scene.
            driver.trackingStateInput = new InputActionProperty(new InputAction(binding: Head + "trackingState", expectedControlType: "Integer"));
        }

        void Update()
        {
            // Until the headset tracks the head, the camera stays at its parent.
            if (_isLevel || transform.parent == null || transform.localPosition == Vector3.zero) return;
            transform.parent.localPosition += Vector3.down * transform.localPosition.y;
            _isLevel = true;
        }
    }
}
