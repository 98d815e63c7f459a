using Nowpose.Frames;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Base class of tests with a running scene and a source that sends poses and signals to it.</summary>
public abstract class PlayedParts
{
    protected const double Latency = 0.08, Visu = 0.04;

    private protected PlayedCell _cell;
    protected MrilSession _session;
    protected string _folder;

    [SetUp]
    public void Start()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-objects-").FullName;
        Begin();
    }

    protected void Begin()
    {
        _cell = new PlayedCell();
        _cell.Player.World.Host.PersistentDataPath = _folder;
        _session = _cell.NewSession();
    }

    [TearDown]
    public void Stop()
    {
        _cell.Dispose();
        Directory.Delete(_folder, true);
    }

    // Returns titles and faults of the shown parts that are not current.
    private protected string FaultsNow()
    {
        var parts = _session.Parts;
        parts.Update();
        return string.Join("; ", Enumerable.Range(0, parts.FaultCount).Select(i => parts.FaultyTitle(i) + ": " + parts.FaultOf(i)));
    }

    // Returns the control time of a scene time: the headset clock starts at 1000 s, and the control clock is 300 s ahead.
    protected static ControlTime At(double seconds) => ControlTime.FromSeconds(1300 + seconds);

    protected T Below<T>(string name, Transform parent) where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }

    protected static T Loose<T>(string name) where T : Component => new GameObject(name).AddComponent<T>();

    // A rig of the robot arm2 below the session; without a description if the text is null.
    protected RobotRig Second(string urdf, RigPose shows = RigPose.Displayed)
    {
        var made = new GameObject("Second");
        made.SetActive(false);
        made.transform.SetParent(_session.transform, false);
        var rig = made.AddComponent<RobotRig>().With("_robotNamespace", "arm2").With("_shows", shows);
        if (urdf != null) rig.With("_description", RobotDescriptionAsset.Create("second", urdf));
        made.SetActive(true);
        return rig;
    }

    protected void SendPose(string parent, string child, double t, in RigidTransform pose) => _session.Session.Listener.FramesReceived(
        new TransformsMessage(pose.ToTransform(At(t), parent, child)), false, HeadsetTime.FromSeconds(1000 + t + Latency));

    protected void SendSignal(string name, double t, double value, double latency = Latency) => _session.Session.Listener.SignalsReceived(
        new SignalsMessage(At(t), new SignalValue(name, value)), HeadsetTime.FromSeconds(1000 + t + latency));

    protected void Run(double seconds, Action<double> send = null, Action seen = null)
    {
        _session.gameObject.SetActive(true);
        _cell.Run(seconds, _session, () =>
        {
            seen?.Invoke();
            send?.Invoke(_cell.Now - Latency);
        });
    }

    protected static RigidTransform Along(double x, double yaw = 0) => RigidTransform.FromXyzRpy(x, 0.2, 0.1, 0, 0, yaw);

    protected static void AssertAt(Transform shown, Transform world, in RigidTransform pose, double within = 1e-4)
    {
        var expected = UnityPoses.ToWorld(pose);
        Assert.That(Vector3.Distance(shown.position, world.TransformPoint(expected.position)), Is.LessThan(within));
        Assert.That(Quaternion.Angle(shown.rotation, world.rotation * expected.rotation), Is.LessThan(0.1));
    }
}
