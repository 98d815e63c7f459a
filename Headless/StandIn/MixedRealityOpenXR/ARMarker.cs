using Microsoft.MixedReality.OpenXR.ARSubsystems;
using UnityEngine;
using UnityEngine.XR.ARFoundation;

namespace Microsoft.MixedReality.OpenXR;

[DefaultExecutionOrder(int.MinValue + 2)]
[DisallowMultipleComponent]
public sealed class ARMarker : ARTrackable<XRMarker, ARMarker>
{
    public Vector2 center => sessionRelativeData.center;
    public Vector2 size => sessionRelativeData.size;
    public float lastSeenTime => sessionRelativeData.lastSeenTime;
    public ARMarkerType markerType => sessionRelativeData.markerType;

    public TransformMode transformMode
    {
        get => sessionRelativeData.transformMode;
        set => ARMarkerManager.Instance.SetTransformMode(trackableId, value);
    }

    public string GetDecodedString() => ARMarkerManager.Instance.GetDecodedString(trackableId);
}
