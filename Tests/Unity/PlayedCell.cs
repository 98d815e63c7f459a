using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>A session component in a played scene, and a control system that hands it exchanges and samples in virtual time.</summary>
sealed class PlayedCell : IDisposable
{
    const double FrameSeconds = 1 / 60.0;
    const double Start = 1000;
    static readonly TimeSpan Latency = TimeSpan.FromMilliseconds(80);
    static readonly TimeSpan OneWay = TimeSpan.FromMilliseconds(1);
    static readonly TimeSpan HeadsetMinusControl = TimeSpan.FromSeconds(-300);

    double _nextSample, _nextExchange;
    long _allocated;
    string[] _names = [];
    AssetLibrary _assets;

    /// <summary>What runs when no test says otherwise: nobody listens where it would connect to.</summary>
    public static SessionSettings Offline { get; } =
        new(new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(40), new PredictionSettings());

    public PlayedCell()
        : this(null)
    {
    }

    /// <param name="assets">Where scenes come from; null for an empty one.</param>
    public PlayedCell(AssetLibrary assets)
    {
        _assets = assets;
        Player = assets == null ? new Player() : new Player(assets);
    }

    public Player Player { get; }
    public SteppedClock Clock { get; } = new();

    /// <summary>Seconds since the start.</summary>
    public double Now { get; private set; }

    /// <summary>Whether exchanges come.</summary>
    public bool IsSyncUp { get; set; } = true;

    /// <summary>Whether samples come.</summary>
    public bool IsPlantUp { get; set; } = true;

    /// <summary>What the console says.</summary>
    public IEnumerable<string> Messages => Player.Logs.Select(log => log.Message);

    /// <summary>What positions are multiplied by before they are sent: a source in another unit.</summary>
    public double Scale { get; set; } = 1;

    /// <summary>An object with a session that is fed by this cell instead of a gateway; inactive, to be filled in and switched on.</summary>
    public MrilSession NewSession(string robot = "youbot", SessionSettings settings = null)
    {
        var cell = new GameObject("Cell");
        cell.SetActive(false);
        var session = cell.AddComponent<MrilSession>().With("_connectOnEnable", false);
        session.Settings = settings ?? Offline;
        session.HeadsetClock = Clock;
        if (robot != null) session.RobotAsset = RobotDescriptionAsset.Create(robot, RobotFiles.LoadText(robot));
        return session;
    }

    /// <summary>A cell of the package, fed in the same way; inactive too. One that names no robot is given the UR5.</summary>
    /// <param name="prefab">Name of the prefab.</param>
    public MrilSession NewSessionOf(string prefab)
    {
        _assets ??= new AssetLibrary(RepositoryFiles.Root);
        var asset = _assets.Load<GameObject>($"Packages/com.nowpose.mril/Runtime/Prefabs/{prefab}.prefab");
        // What is copied of it is asleep, too.
        asset.SetActive(false);
        var session = UnityEngine.Object.Instantiate(asset).GetComponent<MrilSession>().With("_connectOnEnable", false);
        session.Settings = Offline;
        session.HeadsetClock = Clock;
        if (session.RobotAsset == null) session.RobotAsset = RobotDescriptionAsset.Create("ur5", RobotFiles.LoadText("ur5"));
        return session;
    }

    /// <summary>One that is switched on.</summary>
    public MrilSession Play(string robot = "youbot", SessionSettings settings = null)
    {
        var session = NewSession(robot, settings);
        session.gameObject.SetActive(true);
        return session;
    }

    /// <summary>Frames at 60 Hz; what the control system has sent by then is there before each.</summary>
    public void Run(double seconds, MrilSession session, Action seen = null)
    {
        for (var end = Now + seconds; Now < end; seen?.Invoke()) Frame(session);
    }

    /// <summary>One frame, for a session that may be null or destroyed.</summary>
    public void Frame(MrilSession session)
    {
        Now += FrameSeconds;
        Clock.Set(Start + Now);
        if (session != null && session.Session != null) Feed(session.Session);
        var before = GC.GetAllocatedBytesForCurrentThread();
        Player.Step(Now);
        _allocated += GC.GetAllocatedBytesForCurrentThread() - before;
    }

    /// <summary>Bytes that such frames allocate, the player's own part included.</summary>
    /// <param name="run">Runs them; again if need be.</param>
    public long AllocatedIn(Action run)
    {
        var once = MeasureIn(run);
        // On a loaded machine one frame in some ten thousand is booked bytes that do not come again; those of a script would.
        return once == 0 ? 0 : Math.Min(once, MeasureIn(run));
    }

    /// <summary>Of a moving joint at a time of the headset clock, rad or m: swings by 0.004 about 0.005, or as near as its limits allow.</summary>
    public static double PositionAt(RobotModel robot, HeadsetTime at, int joint)
    {
        var limits = robot.MovingJoints[joint].Limits;
        var centre = Math.Clamp(0.005, limits.Lower + 0.005, limits.Upper - 0.005);
        return centre + 0.004 * Math.Sin(at.SinceEpoch.TotalSeconds * (1 + 0.1 * joint));
    }

    public void Dispose() => Player.Dispose();

    long MeasureIn(Action run)
    {
        _allocated = 0;
        run();
        return _allocated;
    }

    void Feed(CompensationSession session)
    {
        var now = new HeadsetTime(TimeSpan.FromSeconds(Start + Now));
        if (IsSyncUp && Now >= _nextExchange) Exchange(session, now);
        if (IsPlantUp && Now >= _nextSample) Sample(session, now);
    }

    void Exchange(CompensationSession session, HeadsetTime now)
    {
        _nextExchange = Now + 0.2;
        var there = Control(now - OneWay);
        session.Clock.Add(new SyncExchange(now - OneWay - OneWay, there, there, now), out _);
    }

    void Sample(CompensationSession session, HeadsetTime now)
    {
        _nextSample = Now + 0.05;
        if (session.Robot.MovingJoints.Count == 0) return;
        if (_names.Length != session.Robot.MovingJoints.Count) _names = [.. session.Robot.MovingJoints.Select(joint => joint.Name)];
        var positions = new double[_names.Length];
        for (var i = 0; i < positions.Length; i++) positions[i] = Scale * PositionAt(session.Robot, now - Latency, i);
        session.Listener.Received(new JointStateMessage(Control(now - Latency), _names, positions), now);
    }

    static ControlTime Control(HeadsetTime at) => new(at.SinceEpoch - HeadsetMinusControl);
}
