using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;

namespace Microsoft.MixedReality.OpenXR;

[DefaultExecutionOrder(int.MinValue + 1)]
[DisallowMultipleComponent]
[RequireComponent(typeof(XROrigin))]
public sealed class ARMarkerManager : ARTrackableManager<
    XRMarkerSubsystem, XRMarkerSubsystemDescriptor, XRMarkerSubsystem.Provider, XRMarker, ARMarker>
{
    public ARMarkerType[] enabledMarkerTypes = { ARMarkerType.QRCode };
    public TransformMode defaultTransformMode = TransformMode.MostStable;

    public static ARMarkerManager Instance { get; private set; }

    public void SetTransformMode(TrackableId trackableId, TransformMode transformMode)
    {
    }

    public string GetDecodedString(TrackableId trackableId)
    {
        if (!enabled || subsystem == null) return null;

        subsystem.TextsAsked++;
        return subsystem.Texts.TryGetValue(trackableId, out var text) ? text : null;
    }

    protected override void OnEnable()
    {
        base.OnEnable();
        Instance = this;
    }
}
