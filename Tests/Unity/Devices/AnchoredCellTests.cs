using Microsoft.MixedReality.OpenXR;
using Microsoft.MixedReality.OpenXR.ARSubsystems;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.OpenXR;
using Nowpose.Simulation;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests a QR code on the robot, a Base Anchor and the device's anchors together, including a restart of the application.</summary>
public sealed class AnchoredCellTests
{
    const string Payload = "nowpose-marker", Cell = "cell 3";
    const float SizeMetres = 0.12f;
    static readonly TrackableId Code = new(5, 5);
    static readonly RigidTransform Base = RigidTransform.FromXyzRpy(2, 0.3, 0.1, 0, 0, 0.7);

    // The code is upright on the front of the base: its printed side faces along x, and its upper edge points up.
    static readonly RigidTransform MarkerInBase = RigidTransform.FromXyzRpy(0.2, 0.05, 0.3, Math.PI / 2, 0, Math.PI / 2);
    static readonly RigidTransform MarkerInCode = RigidTransform.FromXyzRpy(0, 0, 0, -Math.PI / 2, 0, -Math.PI / 2);

    PlayedCell _cell;
    PlayedOrigin _origin;
    XRMarkerSubsystem _codes;
    XRAnchorSubsystem _device;
    XRAnchorStore _kept;
    Random _random;
    MrilSession _session;
    BaseAnchor _anchor;

    [SetUp]
    public void SetUp()
    {
        _cell = new PlayedCell();
        _origin = new PlayedOrigin();
        _codes = _origin.Device.Offer<XRMarkerSubsystem>();
        _device = _origin.Device.Offer<XRAnchorSubsystem>();
        _kept = new XRAnchorStore();
        XRAnchorStore.Loading = _ => Task.FromResult(_kept);
        _random = new Random(3);
        var front = UnityPoses.ToWorld(Base * MarkerInBase * RigidTransform.FromXyzRpy(0, 0, 0.8, 0, 0, 0));
        var print = UnityPoses.ToWorld(Base * MarkerInBase);
        _origin.Head.SetPositionAndRotation(front.position, Quaternion.LookRotation(print.position - front.position, Vector3.up));
        Begin();
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        _origin.Dispose();
        XRAnchorStore.Loading = _ => Task.FromResult<XRAnchorStore>(null);
    }

    void Begin()
    {
        _session = _cell.NewSession();
        _session.gameObject.AddComponent<QrMarkers>();
        _session.gameObject.AddComponent<OpenXrAnchorStore>();
        var anchor = new GameObject("Base");
        anchor.transform.SetParent(_session.transform, false);
        _anchor = anchor.AddComponent<BaseAnchor>();
        _session.gameObject.SetActive(true);
        _anchor.Use(Cell, [new BaseMarker(Payload, MarkerInBase, SizeMetres)]);
        _codes.Texts[Code] = Payload;
    }

    // Simulates that the device sees the code, with 1 mm of noise. Tests call it 30 times per second.
    void See()
    {
        var code = UnityPoses.ToWorld(Base * MarkerInBase * MarkerInCode.Inverse);
        var noise = new Vector3(Noise(), Noise(), Noise());
        var half = SizeMetres / 2;
        var corner = code.position + noise - code.rotation * new Vector3(half, half, 0);
        Report(_origin.InSession(corner, code.rotation));
    }

    void Report(Pose pose)
    {
        const float half = SizeMetres / 2;
        _codes.Report(new XRMarker
        {
            trackableId = Code, pose = pose, center = new Vector2(half, half),
            size = new Vector2(SizeMetres, SizeMetres), lastSeenTime = (float)_cell.Now, trackingState = TrackingState.Tracking,
            markerType = ARMarkerType.QRCode,
        });
    }

    float Noise() => 0.001f * (float)_random.NextNormal();

    void Run(double seconds, bool isSeen)
    {
        var frame = 0;
        _cell.Run(seconds, _session, () =>
        {
            if (isSeen && ++frame % 2 == 0) See();
        });
    }

    double ErrorMm()
    {
        var place = UnityPoses.ToWorld(Base);
        return 1000 * Vector3.Distance(_anchor.transform.position, place.position);
    }

    // In standby, the origin of a HoloLens often moves.
    [TestCase(false, BaseAnchorState.Searching)]
    [TestCase(true, BaseAnchorState.Locked)]
    public void Resume_WithOrWithoutAnAnchor_BaseStaysLockedOnlyWithOne(bool accepts, BaseAnchorState expected)
    {
        _device.Accepts = accepts;
        Run(4, true);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked), "no pause so far");

        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        Run(0.5, false);

        Assert.That(_anchor.State, Is.EqualTo(expected));
    }

    [Test]
    public void Base_CodeInView_IsLockedAndStoredUnderTheCellsName()
    {
        Run(3, isSeen: true);
        Run(1, isSeen: false);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked), _anchor.Words);
        Assert.That(ErrorMm(), Is.LessThan(1.5));
        Assert.That(_kept.PersistedAnchorNames, Is.EqualTo(new[] { Cell }));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    // Positions of the XR Origin in the scene. They determine where the session's origin is in the world.
    static readonly Vector3[] Origins = [Vector3.zero, new(0, 1.6f, 0), new(1, 0.5f, -2)];

    [TestCaseSource(nameof(Origins))]
    public void Base_AnchorAtTheSessionsOrigin_DoesNotMoveAndIsLost(Vector3 origin)
    {
        Stand(origin);
        Run(3, isSeen: true);
        Run(1, isSeen: false);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked), _anchor.Words);
        var place = _anchor.transform.position;

        _device.Place(_kept.KeptAs(Cell), new Pose(Vector3.zero, Quaternion.identity), TrackingState.Tracking);
        Run(2, isSeen: false);

        Assert.That(Vector3.Distance(_anchor.transform.position, place), Is.LessThan(1e-5));
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Lost));
        _device.Place(_kept.KeptAs(Cell), _origin.InSession(place, _anchor.transform.rotation), TrackingState.Tracking);
        Run(1, isSeen: false);
        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
    }

    [TestCaseSource(nameof(Origins))]
    public void Base_CodeAtTheSessionsOrigin_IsNeverLocked(Vector3 origin)
    {
        Stand(origin);
        _origin.Head.SetPositionAndRotation(origin + new Vector3(0, 0, 0.8f), Quaternion.Euler(0, 180, 0));

        _cell.Run(4, _session, () => Report(new Pose(Vector3.zero, Quaternion.identity)));

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Searching), _anchor.Words);
        Assert.That(_anchor.Tracker.Markers[0].Fault, Is.EqualTo(SightingFault.NotTracked));
    }

    void Stand(Vector3 origin)
    {
        var head = (_origin.Head.position, _origin.Head.rotation);
        _origin.Origin.transform.SetPositionAndRotation(origin, origin == Vector3.zero ? Quaternion.identity : Quaternion.Euler(0, 30, 0));
        _origin.Head.SetPositionAndRotation(head.position, head.rotation);
    }

    [Test]
    public void Base_ApplicationRestarted_IsRestoredWithoutACode()
    {
        Run(3, isSeen: true);
        Run(1, isSeen: false);
        var place = (_anchor.transform.position, _anchor.transform.rotation);
        var id = _kept.KeptAs(Cell);

        Object.Destroy(_session.gameObject);
        _codes.Remove(Code);
        _cell.Frame(null);
        Begin();
        Run(1, isSeen: false);
        _device.Place(id, _origin.InSession(place.position, place.rotation), TrackingState.Tracking);
        Run(3, isSeen: false);

        Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Restored), _anchor.Words);
        Assert.That(Vector3.Distance(_anchor.transform.position, place.position), Is.LessThan(1e-3));
    }
}
