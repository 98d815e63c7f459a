using System.Reflection;
using System.Runtime.CompilerServices;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Benchmarks.Cell;

/// <summary>A scene in the stand-in engine, in virtual time: the package's robot cell with a second robot and tracked objects.</summary>
sealed class ObjectScene : IDisposable, IHeadsetClock
{
    const double FrameSeconds = 1 / 60.0, Latency = 0.08, ExchangeSeconds = 0.2;
    const string Prefab = "Packages/com.nowpose.mril/Runtime/Prefabs/Nowpose Robot Cell.prefab", SecondRobot = "arm2";

    static readonly TimeSpan OneWay = TimeSpan.FromMilliseconds(1);

    readonly Player _player;
    readonly MrilSession _session;
    readonly TrackedObject[] _objects;
    readonly string[] _joints;

    // Position in the middle of each joint's limits; 0 for a joint without limits.
    readonly double[] _middles;
    readonly bool _isPlane;
    readonly double _interval;
    double _now = 100, _nextSample = 100, _nextExchange;
    long _frame;

    /// <param name="isPlane">Whether the objects move in a plane, as on a conveyor. If not, they move in all six coordinates.</param>
    /// <param name="interval">Sampling interval of objects and robots, s.</param>
    public ObjectScene(int objects, bool isPlane, double interval, string predictor)
    {
        (_isPlane, _interval) = (isPlane, interval);
        var assets = new AssetLibrary(ProjectRoot());
        _player = new Player(assets);
        var prefab = assets.Load<GameObject>(Prefab);
        // This class delivers the data, so the cell must not connect to a gateway. It must stay inactive until its clock is set.
        Set(prefab.GetComponent<MrilSession>(), "_connectOnEnable", false);
        prefab.SetActive(false);
        _session = UnityEngine.Object.Instantiate(prefab).GetComponent<MrilSession>();
        _session.HeadsetClock = this;
        _session.Settings = new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), new PredictionSettings(predictor));
        var anchor = _session.GetComponentInChildren<BaseAnchor>(includeInactive: true).transform;
        var second = Below<RobotRig>(SecondRobot, anchor);
        Set(second, "_robotNamespace", SecondRobot);
        Set(second, "_description", _session.RobotAsset);
        _objects = [.. Enumerable.Range(0, objects).Select(i => Below<TrackedObject>("object" + i, anchor))];
        _session.gameObject.SetActive(true);
        _joints = [.. _session.Robot.MovingJoints.Select(joint => joint.Name)];
        _middles = [.. _session.Robot.MovingJoints.Select(joint => (joint.Limits.Lower + joint.Limits.Upper) / 2).Select(middle => double.IsFinite(middle) ? middle : 0)];
    }

    public HeadsetTime Now => HeadsetTime.FromSeconds(_now);

    /// <summary>Whether the displayed poses of all objects and both robots are current.</summary>
    public bool IsCurrent => Enumerable.Range(0, _session.Session.Robots.Count).All(i => _session.Session.Robots[i].Frame.State == PoseState.Current)
        && _objects.All(shown => shown.State == PoseState.Current);

    /// <summary>Plays one frame: delivers the messages that are due and runs the player loop.</summary>
    /// <param name="hasSamples">Whether samples were delivered.</param>
    /// <returns>CPU time of the player loop, s, and the number of bytes that it allocated.</returns>
    public (double Seconds, long Bytes) Play(out bool hasSamples)
    {
        _frame++;
        _now = 100 + _frame * FrameSeconds;
        if (_now >= _nextExchange) Exchange();
        hasSamples = _nextSample + Latency <= _now;
        for (; _nextSample + Latency <= _now; _nextSample += _interval) Send(_nextSample);
        var (bytes, start) = (GC.GetAllocatedBytesForCurrentThread(), ThreadTime.Seconds);
        _player.Step(_frame * FrameSeconds);
        return (ThreadTime.Seconds - start, GC.GetAllocatedBytesForCurrentThread() - bytes);
    }

    public void Dispose() => _player.Dispose();

    void Exchange()
    {
        _nextExchange = _now + ExchangeSeconds;
        var there = ControlTime.FromSeconds(_now);
        _session.Session.Clock.Add(new SyncExchange(Now - OneWay, there, there, Now + OneWay), out _);
    }

    void Send(double t)
    {
        var (stamp, arrival, listener) = (ControlTime.FromSeconds(t), HeadsetTime.FromSeconds(t + Latency), _session.Session.Listener);
        if (_objects.Length > 0)
            listener.FramesReceived(
                new TransformsMessage([.. _objects.Select((_, i) => PoseAt(t, i).ToTransform(stamp, FrameParents.World, "object" + i))]), false, arrival);
        foreach (var robot in new[] { "", SecondRobot })
            listener.Received(new JointStateMessage(stamp, _joints, [.. _middles.Select((middle, i) => middle + 0.1 * Math.Sin(t + i))]), arrival, robot);
    }

    // The objects differ in phase. All angular frequencies are multiples of 0.1 rad/s, so the motion repeats after 63 s.
    RigidTransform PoseAt(double t, int i) => _isPlane
        ? RigidTransform.FromXyzRpy(0.3 * Math.Sin(t + i), 0.2 * Math.Cos(1.7 * t), 0.7, 0, 0, 0.5 * Math.Sin(1.3 * t))
        : RigidTransform.FromXyzRpy(
            0.3 * Math.Sin(t + i), 0.2 * Math.Cos(1.7 * t), 0.7 + 0.1 * Math.Sin(2.3 * t), 0.3 * Math.Sin(1.3 * t), 0.2 * Math.Cos(1.9 * t), Math.Sin(0.7 * t));

    static T Below<T>(string name, Transform parent) where T : Component
    {
        var made = new GameObject(name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }

    // Sets a field as the Inspector does.
    static void Set(Component component, string field, object value) =>
        component.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(component, value);

    static string ProjectRoot([CallerFilePath] string thisFile = "") => Path.GetFullPath("../../..", thisFile);
}
