using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Samples;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Runs the sample Virtual Robot Cell at 60 frames per second in virtual time, and measures distances between transforms.</summary>
sealed class PlayedSample : IDisposable
{
    int _frames;

    /// <summary>Builds the cell from its components. They are inactive until <see cref="Start"/>.</summary>
    public PlayedSample(string robot = "youbot", bool sessionKnowsTheRobot = true)
    {
        Player = new Player();
        var asset = RobotDescriptionAsset.Create(robot, RobotFiles.LoadText(robot));
        Cell = Sleeping("Cell");
        Session = Cell.AddComponent<MrilSession>().With("_connectOnEnable", false);
        Session.HeadsetClock = Clock;
        Session.Settings = new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)));
        if (sessionKnowsTheRobot) Session.RobotAsset = asset;
        Displayed = Rig("Robot", RigPose.Displayed);
        Held = Rig("Ghost", RigPose.Held);
        Control = Sleeping("Simulated Control System").AddComponent<SimulatedControlSystem>().With("_session", Session).With("_robot", asset);
        Truth = Sleeping("Real Robot").AddComponent<RobotRig>();
        Truth.gameObject.AddComponent<TruthRig>().With("_controlSystem", Control);
    }

    PlayedSample(ScenePath scene)
    {
        Player = new Player(RepositoryAssets.NewLibrary());
        Player.LoadScene(scene.Path);
        Session = Player.Find<MrilSession>();
        Session.HeadsetClock = Clock;
        // Restarts the session, which has already started with the clock of this machine.
        Session.Settings = Session.Settings;
        Cell = Session.gameObject;
        Displayed = Cell.transform.Find("Base Anchor/Robot").GetComponent<RobotRig>();
        Held = Cell.transform.Find("Base Anchor/Ghost").GetComponent<RobotRig>();
        Control = Player.Find<SimulatedControlSystem>();
        Truth = GameObject.Find("Real Robot").GetComponent<RobotRig>();
    }

    public Player Player { get; }
    public GameObject Cell { get; }
    public MrilSession Session { get; }
    public SimulatedControlSystem Control { get; }
    public RobotRig Displayed { get; }
    public RobotRig Held { get; }
    public RobotRig Truth { get; }
    public SteppedClock Clock { get; } = new();

    /// <summary>States of the frames of the last <see cref="Run"/>.</summary>
    public List<PoseState> States { get; } = [];

    /// <summary>Distances in metres of the displayed tool from the true tool, in the frames whose pose was current.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>Distances in metres of the ghost's tool from the true tool, in the frames of <see cref="Errors"/>.</summary>
    public List<double> HoldErrors { get; } = [];

    /// <summary>Loads the scene of the sample, and activates it.</summary>
    public static PlayedSample OfScene(string scene = "Packages/com.nowpose.mril/Samples~/Virtual Robot Cell/Virtual Robot Cell.unity") =>
        new(new ScenePath(scene));

    public PlayedSample Start()
    {
        Cell.SetActive(true);
        Control.gameObject.SetActive(true);
        Truth.gameObject.SetActive(true);
        return this;
    }

    public PlayedSample Run(double seconds)
    {
        States.Clear();
        Errors.Clear();
        HoldErrors.Clear();
        for (var i = 0; i < (int)Math.Round(seconds * 60); i++) Step();
        return this;
    }

    public void Step()
    {
        Clock.Set(100 + _frames / 60.0);
        Player.Step(_frames++ / 60.0);
        if (Session.Frame == null) return;
        States.Add(Session.Frame.State);
        if (Session.Frame.State != PoseState.Current) return;
        Errors.Add(Distance(Displayed, Truth));
        HoldErrors.Add(Distance(Held, Truth));
    }

    public void Dispose() => Player.Dispose();

    // The object is inactive until all fields are assigned, because in a scene fields are set before Awake.
    static GameObject Sleeping(string name)
    {
        var made = new GameObject(name);
        made.SetActive(false);
        return made;
    }

    // Distinguishes the path of a scene from the name of a robot.
    readonly record struct ScenePath(string Path);

    RobotRig Rig(string name, RigPose shows)
    {
        var rig = new GameObject(name);
        rig.transform.SetParent(Cell.transform, worldPositionStays: false);
        return rig.AddComponent<RobotRig>().With("_shows", shows);
    }

    static double Distance(RobotRig a, RobotRig b) => Vector3.Distance(a.Tool.position, b.Tool.position);
}
