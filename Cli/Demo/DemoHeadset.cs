using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Cli.Demo;

/// <summary>
/// Simulates the headset: plays the package's sample scene on the stand-in engine, and reads the displayed poses from the scene's transforms.
/// </summary>
sealed class DemoHeadset : IDemoHeadset
{
    const string Package = "Packages/com.nowpose.mril/";
    const string Sample = Package + "Samples~/Connect to a Gateway/";

    readonly Player _player;
    readonly MrilSession _component;
    readonly RobotRig _displayed;
    readonly RobotRig _held;
    CompensationSession _watched;

    /// <param name="clock">The headset clock, which also controls the frame loop.</param>
    /// <param name="samples">Expected number of samples. More samples are accepted.</param>
    /// <param name="recordingPath">Path of the session's recording; null to record nothing.</param>
    public DemoHeadset(RobotModel robot, SessionSettings settings, IHeadsetClock clock, int samples, string recordingPath = null)
    {
        Recording = new DemoRecording(recordingPath, DateTime.UtcNow);
        Log = new DemoLog(samples);
        var assets = new AssetLibrary(Path.Combine(AppContext.BaseDirectory, "UnityProject"));
        _player = new Player(assets);
        _player.ConnectDisplay(DemoDisplay.FramesPerSecond);
        // Sets the clock and the settings before the scene starts, because the component connects immediately.
        _player.LoadScene(Sample + SceneFor(robot, assets), roots =>
        {
            var component = roots.SelectMany(root => root.GetComponentsInChildren<MrilSession>(includeInactive: true)).Single();
            component.HeadsetClock = clock;
            component.Settings = settings;
            // Uses the demo's own calibration. Profiles stored on this machine belong to other devices.
            foreach (var loader in roots.SelectMany(root => root.GetComponentsInChildren<LatencyProfileLoader>(includeInactive: true)))
                loader.enabled = false;
        });
        _component = _player.Find<MrilSession>();
        _component.Changed += change =>
        {
            if ((change & SessionChange.LeftRange) != 0) Alarms++;
        };
        var ghost = _component.GetComponentInChildren<Ghost>(includeInactive: true);
        ghost.Visible = true;
        _held = ghost.GetComponent<RobotRig>();
        _displayed = _component.GetComponentsInChildren<RobotRig>().First(rig => rig.Shows == RigPose.Displayed);
    }

    public DisplayFrame Frame => _component.Frame;

    public CompensationSession Session => _component.Session;

    public DemoLog Log { get; }

    public DemoRecording Recording { get; }

    /// <summary>Displayed position of the tool, in the base frame of the robot; the origin before the robot is known.</summary>
    public ToolPosition Tool => ToolOf(_displayed);

    /// <summary>Position of the tool without compensation, in the base frame of the robot. It comes from the ghost in the scene.</summary>
    public ToolPosition HeldTool => ToolOf(_held);

    /// <summary>Number of alarms that the scene raised because the render time left the constant-latency range.</summary>
    public int Alarms { get; private set; }

    /// <summary>First error that the scene's scripts have logged; null if there is none.</summary>
    public string Complaint => _player.Logs
        .Where(entry => entry.Type is LogType.Error or LogType.Exception or LogType.Assert).Select(entry => entry.ToString()).FirstOrDefault();

    public void ReportGpuTime(TimeSpan length) => _player.ReportGpuTime(length);

    public void Step(double seconds)
    {
        Watch();
        _player.Step(seconds);
    }

    public void Dispose()
    {
        Recording.Dispose();
        _player.Dispose();
    }

    // The youBot has a prefab with its own scene. Any other robot is built from the gateway's description.
    static string SceneFor(RobotModel robot, AssetLibrary assets) =>
        assets.Load<RobotDescriptionAsset>(Package + "Runtime/Robots/youBot.asset").Read().SourceHash == robot.SourceHash
            ? "Connect to a Gateway.unity"
            : "Connect to a Gateway (Any Robot).unity";

    static ToolPosition ToolOf(RobotRig rig)
    {
        if (rig.Tool == null) return default;
        var place = rig.transform.InverseTransformPoint(rig.Tool.position);
        return ToolPosition.Of(UnityFrame.FromUnity(new UnityPose(place.x, place.y, place.z, 0, 0, 0, 1)));
    }

    // Follows the current session. The session is replaced when the gateway has described the robot.
    void Watch()
    {
        var session = _component.Session;
        if (session == _watched || session == null) return;
        _watched = session;
        Log.Follow(session);
        Recording.Start(session);
    }
}
