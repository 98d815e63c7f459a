using Microsoft.MixedReality.OpenXR;
using Nowpose.Anchoring;
using Nowpose.ArFoundation;
using Nowpose.Kinematics;
using Nowpose.OpenXR;
using Nowpose.Unity;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates a device that holds anchors, with a store that saves them across restarts of the application.</summary>
sealed class PlayedAnchorStore : IDisposable
{
    public static readonly RigidTransform Place = RigidTransform.FromXyzRpy(1.5, -0.4, 0.8, 0.1, 0.2, 0.3);
    public static readonly TrackableId Earlier = new(7, 7);

    public PlayedAnchorStore()
    {
        Cell = new PlayedCell();
        Origin = new PlayedOrigin();
        Device = Origin.Device.Offer<XRAnchorSubsystem>();
        Storage = new XRAnchorStore();
        XRAnchorStore.Loading = _ => Task.FromResult(Storage);
        // The store component requires ArSpatialAnchors, so Unity adds it.
        Store = new GameObject("Anchors").AddComponent<OpenXrAnchorStore>();
        Anchors = Store.GetComponent<ArSpatialAnchors>();
    }

    public PlayedCell Cell { get; }
    public PlayedOrigin Origin { get; }
    public XRAnchorSubsystem Device { get; }
    public XRAnchorStore Storage { get; }
    public OpenXrAnchorStore Store { get; }
    public ArSpatialAnchors Anchors { get; }

    public void Run(double seconds) => Cell.Run(seconds, null);

    public ISpatialAnchor Kept(string name)
    {
        var anchor = Anchors.Hold(Place);
        anchor.Keep(name);
        Run(0.2);
        return anchor;
    }

    public void Dispose()
    {
        Cell.Dispose();
        Origin.Dispose();
        XRAnchorStore.Loading = _ => Task.FromResult<XRAnchorStore>(null);
    }
}
