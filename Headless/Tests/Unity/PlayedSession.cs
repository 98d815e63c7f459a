using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Headless.Tests.Unity;

/// <summary>
/// A session in a scene that plays at 60 fps in virtual time: a robot of two joints whose samples come every 50 ms, 60 ms old;
/// the clock is exchanged every 200 ms. No sockets.
/// </summary>
sealed class PlayedSession : IDisposable
{
    const string Urdf = """
        <robot name='two'>
            <link name='base'/><link name='upper'/><link name='lower'/><link name='tool_centre_point'/>
            <joint name='shoulder' type='continuous'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/></joint>
            <joint name='elbow' type='continuous'><parent link='upper'/><child link='lower'/><origin xyz='0.5 0 0'/><axis xyz='0 0 1'/></joint>
            <joint name='tool' type='fixed'><parent link='lower'/><child link='tool_centre_point'/><origin xyz='0.5 0 0'/></joint>
        </robot>
        """;

    static readonly string[] Joints = ["shoulder", "elbow"];

    int _frames;

    public PlayedSession(ConstantLatencyRange range = null)
    {
        Settings = new SessionSettings(
            new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), range: range);
        Player = new Player();
        Cell = new GameObject("Cell");
        Cell.SetActive(false);
        Session = Cell.AddComponent<MrilSession>().With("_connectOnEnable", false);
        Session.HeadsetClock = Clock;
        Session.Settings = Settings;
        Session.RobotAsset = RobotDescriptionAsset.Create("two", Urdf);
    }

    public SessionSettings Settings { get; }

    public Player Player { get; }

    /// <summary>Has the session; not active until <see cref="Start"/>, so that a test can add to it.</summary>
    public GameObject Cell { get; }

    public MrilSession Session { get; }

    public PlayedClock Clock { get; } = new();

    /// <summary>Bytes that the player's frames have allocated so far; what the test feeds it with is not among them.</summary>
    public long Allocated { get; private set; }

    public bool IsSampling { get; set; } = true;

    public bool IsSynchronising { get; set; } = true;

    /// <summary>Called in each frame before the player's.</summary>
    public Action<int> EachFrame { get; set; }

    public PlayedSession Start()
    {
        Cell.SetActive(true);
        return this;
    }

    public PlayedSession Run(double seconds)
    {
        for (var i = 0; i < (int)Math.Round(seconds * 60); i++) Step();
        return this;
    }

    public void Step()
    {
        var now = HeadsetTime.FromSeconds(100 + _frames / 60.0);
        Clock.Now = now;
        if (Session.Session != null) Feed(Session.Session, now);
        EachFrame?.Invoke(_frames);
        var before = GC.GetAllocatedBytesForCurrentThread();
        Player.Step(_frames++ / 60.0);
        Allocated += GC.GetAllocatedBytesForCurrentThread() - before;
    }

    public void Dispose() => Player.Dispose();

    void Feed(CompensationSession session, HeadsetTime now)
    {
        var control = new ControlTime(now.SinceEpoch);
        if (IsSynchronising && _frames % 12 == 0)
        {
            var answered = control - TimeSpan.FromMilliseconds(1);
            session.Clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(2), answered, answered, now), out _);
        }
        if (!IsSampling || _frames % 3 != 0) return;
        var taken = control - TimeSpan.FromMilliseconds(60);
        var t = taken.SinceEpoch.TotalSeconds;
        session.Received(new JointStateMessage(taken, Joints, [Math.Sin(t), 0.5 * Math.Cos(t)]), now);
    }
}
