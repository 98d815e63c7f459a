using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Nowpose.Anchoring;
using Nowpose.OpenXR;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates a device that reports a code on a tilted print, with the component that reads the code in a running session.</summary>
sealed class PlayedCodes : IDisposable
{
    public static readonly TrackableId Id = new(0xAB, 0xCD);
    public static readonly Vector3 Corner = new(2, 1, 3);

    // With this rotation, no axis of the print is parallel to an axis of the room.
    public static readonly Quaternion Turned = Quaternion.Euler(20, 50, 10);

    public PlayedCodes()
    {
        Cell = new PlayedCell();
        Origin = new PlayedOrigin();
        Codes = Origin.Device.Offer<XRMarkerSubsystem>();
        Session = Cell.NewSession();
        Markers = Session.gameObject.AddComponent<QrMarkers>();
        Session.gameObject.SetActive(true);
        Cell.Frame(Session);
        Cell.Frame(Session);
    }

    public PlayedCell Cell { get; }
    public PlayedOrigin Origin { get; }
    public XRMarkerSubsystem Codes { get; }
    public MrilSession Session { get; }
    public QrMarkers Markers { get; }

    public void Report(
        float lastSeenAgo = 0.02f, TrackingState state = TrackingState.Tracking, TransformMode mode = TransformMode.MostStable, TrackableId? id = null)
    {
        Codes.Report(new XRMarker
        {
            trackableId = id ?? Id,
            pose = Origin.InSession(Corner, Turned),
            center = new Vector2(0.06f, 0.06f),
            size = new Vector2(0.12f, 0.12f),
            lastSeenTime = (float)Cell.Now - lastSeenAgo,
            trackingState = state,
            transformMode = mode,
            markerType = ARMarkerType.QRCode,
        });
    }

    public List<MarkerSighting> Read()
    {
        var markers = new List<MarkerSighting>();
        Markers.Read(markers);
        return markers;
    }

    public MarkerSighting ReadOne()
    {
        Cell.Frame(Session);
        var markers = Read();
        Assert.That(markers, Has.Count.EqualTo(1));
        return markers[0];
    }

    public void Dispose()
    {
        Cell.Dispose();
        Origin.Dispose();
    }
}
