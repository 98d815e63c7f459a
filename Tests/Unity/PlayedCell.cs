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

/// <summary>A running scene, and a simulated control system that sends clock exchanges and samples to a session in virtual time.</summary>
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

    /// <summary>Default settings with ports that are closed.</summary>
    public static SessionSettings Offline { get; } =
        new(new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(40), new PredictionSettings());

    public PlayedCell()
        : this(null)
    {
    }

    /// <param name="assets">Library from which scenes and prefabs are loaded; null for an empty scene.</param>
    public PlayedCell(AssetLibrary assets)
    {
        _assets = assets;
        Player = assets == null ? new Player() : new Player(assets);
    }

    public Player Player { get; }
    public SteppedClock Clock { get; } = new();

    /// <summary>Time since the start in s.</summary>
    public double Now { get; private set; }

    /// <summary>Whether clock exchanges succeed.</summary>
    public bool IsSyncUp { get; set; } = true;

    /// <summary>Whether samples arrive.</summary>
    public bool IsPlantUp { get; set; } = true;

    /// <summary>Time between two samples in s.</summary>
    public double SampleSeconds { get; set; } = 0.05;

    /// <summary>Sum of all steps of the control clock in s.</summary>
    public double ControlStepSeconds { get; set; }

    /// <summary>Messages in the console.</summary>
    public IEnumerable<string> Messages => Player.Logs.Select(log => log.Message);

    /// <summary>Factor by which all sent positions are multiplied, to simulate a source with another unit.</summary>
    public double Scale { get; set; } = 1;

    /// <summary>Creates an inactive object with a session that receives its data from this cell and not from a gateway.</summary>
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

    /// <summary>Creates an inactive instance of a cell prefab whose session receives its data from this cell.</summary>
    /// <param name="prefab">Name of the prefab. If it has no robot, its robot is the UR5.</param>
    public MrilSession NewSessionOf(string prefab)
    {
        _assets ??= RepositoryAssets.NewLibrary();
        var asset = _assets.Load<GameObject>($"Packages/com.nowpose.mril/Runtime/Prefabs/{prefab}.prefab");
        // The copy of an inactive object is inactive.
        asset.SetActive(false);
        var session = UnityEngine.Object.Instantiate(asset).GetComponent<MrilSession>().With("_connectOnEnable", false);
        session.Settings = Offline;
        session.HeadsetClock = Clock;
        if (session.RobotAsset == null) session.RobotAsset = RobotDescriptionAsset.Create("ur5", RobotFiles.LoadText("ur5"));
        return session;
    }

    /// <summary>Creates an active session.</summary>
    public MrilSession Play(string robot = "youbot", SessionSettings settings = null)
    {
        var session = NewSession(robot, settings);
        session.gameObject.SetActive(true);
        return session;
    }

    /// <summary>Runs frames at 60 Hz. Before each frame, the session receives the data that the control system has sent.</summary>
    public void Run(double seconds, MrilSession session, Action seen = null)
    {
        for (var end = Now + seconds; Now < end; seen?.Invoke()) Frame(session);
    }

    /// <summary>Runs one frame. The session may be null or destroyed.</summary>
    public void Frame(MrilSession session)
    {
        Now += FrameSeconds;
        Clock.Set(Start + Now);
        if (session != null && session.Session != null) Feed(session.Session);
        var before = GC.GetAllocatedBytesForCurrentThread();
        Player.Step(Now);
        _allocated += GC.GetAllocatedBytesForCurrentThread() - before;
    }

    /// <summary>Returns the number of bytes that frames allocate, including allocations of the player.</summary>
    /// <param name="run">Runs the frames. It is called a second time if the first run allocates.</param>
    public long AllocatedIn(Action run)
    {
        var once = MeasureIn(run);
        // On a loaded machine, about one frame in ten thousand shows an allocation that does not recur. Allocations of scripts recur in each run.
        return once == 0 ? 0 : Math.Min(once, MeasureIn(run));
    }

    /// <summary>
    /// Returns the true position of a moving joint at a headset time, in rad or m. It oscillates around 0.005 with the amplitude 0.004, within the
    /// limits of the joint.
    /// </summary>
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
        _nextSample = Now + SampleSeconds;
        if (session.Robot.MovingJoints.Count == 0) return;
        if (_names.Length != session.Robot.MovingJoints.Count) _names = [.. session.Robot.MovingJoints.Select(joint => joint.Name)];
        var positions = new double[_names.Length];
        for (var i = 0; i < positions.Length; i++) positions[i] = Scale * PositionAt(session.Robot, now - Latency, i);
        session.Listener.Received(new JointStateMessage(Control(now - Latency), _names, positions), now);
    }

    ControlTime Control(HeadsetTime at) => new(at.SinceEpoch - HeadsetMinusControl + TimeSpan.FromSeconds(ControlStepSeconds));
}
