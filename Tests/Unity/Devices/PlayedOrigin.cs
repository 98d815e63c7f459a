using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates a headset: a runtime, and a camera below an XR Origin that is not at the origin of the room.</summary>
sealed class PlayedOrigin : IDisposable
{
    public PlayedOrigin()
    {
        Device = new ArDevice();
        Origin = new GameObject("XR Origin").AddComponent<XROrigin>();
        Origin.transform.SetPositionAndRotation(new Vector3(1, 0.5f, -2), Quaternion.Euler(0, 30, 0));
        Head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        Head.SetParent(Origin.transform, false);
    }

    public ArDevice Device { get; }
    public XROrigin Origin { get; }
    public Transform Head { get; }

    /// <summary>Converts a pose in the room to the space of the device's session.</summary>
    public Pose InSession(Vector3 position, Quaternion rotation)
    {
        var space = Origin.TrackablesParent;
        return new Pose(space.InverseTransformPoint(position), Quaternion.Inverse(space.rotation) * rotation);
    }

    public void Dispose() => Device.Dispose();
}
