using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Session;

namespace Nowpose.Cli.Demo.Virtual;

/// <summary>A headset without a scene: a session and forward kinematics. Several of them can run at the same time, unlike scenes.</summary>
sealed class SessionHeadset : IDemoHeadset
{
    readonly IHeadsetClock _clock;
    readonly ToolKinematics _kinematics;
    int _nextFlush;

    /// <param name="clock">The headset clock, which also controls the frame loop.</param>
    /// <param name="samples">Expected number of samples. More samples are accepted.</param>
    /// <param name="recordingPath">Path of the session's recording; null to record nothing.</param>
    public SessionHeadset(RobotModel robot, SessionSettings settings, IHeadsetClock clock, int samples, string recordingPath = null)
    {
        _clock = clock;
        _kinematics = new ToolKinematics(robot);
        Session = new CompensationSession(settings, robot, clock)
        {
            Conditions = new DisplayConditions(displayHz: DemoDisplay.FramesPerSecond),
        };
        Log = new DemoLog(samples);
        Log.Follow(Session);
        // Without a date, the same settings give the same file.
        Recording = new DemoRecording(recordingPath, startedUtc: null);
        Recording.Start(Session);
    }

    public DisplayFrame Frame { get; private set; }

    public CompensationSession Session { get; }

    public DemoLog Log { get; }

    public DemoRecording Recording { get; }

    public ToolPosition Tool => Frame == null ? default : _kinematics.At(Frame.Joints);

    public ToolPosition HeldTool => Frame == null ? default : _kinematics.At(Frame.HeldJoints);

    /// <summary>Always 0, because only scenes raise alarms.</summary>
    public int Alarms => 0;

    public void ReportGpuTime(TimeSpan length) => Session.Rendered(length, RenderTimeSourceKind.DisplayGpuTime);

    public void Step(double seconds)
    {
        Frame = Session.Tick(_clock.Now);
        // Virtual time is faster than the disk, and the recorder stores only the lines of a few seconds.
        if (seconds < _nextFlush) return;
        _nextFlush++;
        Recording.Flush();
    }

    public void Dispose()
    {
        Recording.Dispose();
        Session.Dispose();
    }
}
