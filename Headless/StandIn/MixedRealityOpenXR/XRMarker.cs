using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR.ARSubsystems;

public struct XRMarker : ITrackable
{
    public TrackableId trackableId { get; internal set; }
    public Pose pose { get; internal set; }
    public TrackingState trackingState { get; internal set; }
    public Vector2 center { get; internal set; }
    public Vector2 size { get; internal set; }
    public float lastSeenTime { get; internal set; }
    public TransformMode transformMode { get; internal set; }
    public ARMarkerType markerType { get; internal set; }
}
