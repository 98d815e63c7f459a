using Nowpose.Anchoring;
using Nowpose.Editor.Setup;
using Nowpose.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Anchoring;

/// <summary>A running cell of the package with a base anchor, a device that sees markers, and a head that looks at them.</summary>
sealed class PlayedBaseAnchor : IDisposable
{
    public static readonly RigidTransform Base = RigidTransform.FromXyzRpy(1, 0.3, -0.4, 0, 0, 2);
    public static readonly RigidTransform InBase = RigidTransform.FromXyzRpy(0.25, 0, 0, 0, 0, 0.5);

    public PlayedBaseAnchor()
    {
        Cell = new PlayedCell();
        Head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        Session = Cell.NewSessionOf("Nowpose Robot Cell");
        Anchor = Session.GetComponentInChildren<BaseAnchor>(true);
        Markers = Session.gameObject.AddComponent<FakeMarkers>();
        Markers.Clock = Cell.Clock;
        Markers.Base = Base;
        Markers.Markers["a"] = InBase;
        LookDownAt(Base);
    }

    /// <summary>The marker "a" at <see cref="InBase"/>, as it is entered in the Inspector.</summary>
    public static AnchorMarker Marker => new("a", new Vector3(0.25f, 0, 0), new Vector3(0, 0, 0.5f * Mathf.Rad2Deg));

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public BaseAnchor Anchor { get; }
    public FakeMarkers Markers { get; }
    public Transform Head { get; }

    public void Play(params AnchorMarker[] markers)
    {
        Anchor.With("_markers", markers.ToList()).With("_cell", "cell 7");
        Session.gameObject.SetActive(true);
    }

    public void PlayOne() => Play(Marker);

    public void PlayLocked()
    {
        PlayOne();
        Cell.Run(4, Session);
        Assert.That(Anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    public (float Metres, float Degrees) OffFrom(in RigidTransform place)
    {
        var pose = UnityPoses.ToWorld(place);
        return (Vector3.Distance(Anchor.transform.position, pose.position), Quaternion.Angle(Anchor.transform.rotation, pose.rotation));
    }

    public IEnumerable<string> Logged => Cell.Messages.Where(message => message.Contains("base anchor"));

    public (float Fade, float Hatch, string Words) Look()
    {
        var appearance = Anchor.GetComponentInChildren<PoseAppearance>();
        var block = new MaterialPropertyBlock();
        appearance.GetComponentsInChildren<MeshRenderer>().First(r => r.sharedMaterial.HasProperty("_Hatch")).GetPropertyBlock(block);
        return (
            block.GetFloat(Shader.PropertyToID("_Fade")), block.GetFloat(Shader.PropertyToID("_Hatch")),
            appearance.GetComponentsInChildren<TextMesh>().Single(text => text.name == "Words").text);
    }

    public void Dispose() => Cell.Dispose();

    // Places the head 1 m above a place and 0.2 m to its side, and makes it look straight down.
    void LookDownAt(in RigidTransform place)
    {
        var pose = UnityPoses.ToWorld(place);
        Head.SetPositionAndRotation(pose.position + new Vector3(0.2f, 1, 0), Quaternion.Euler(90, 0, 0));
    }
}
