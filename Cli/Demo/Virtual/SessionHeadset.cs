using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Cli.Demo.Virtual;

/// <summary>A headset without a scene: a session and forward kinematics. Several of them can run at the same time, unlike scenes.</summary>
sealed class SessionHeadset : IDemoHeadset
{
    readonly IHeadsetClock _clock;
    readonly ToolKinematics _kinematics;

    public SessionHeadset(RobotModel robot, SessionSettings settings, IHeadsetClock clock, int samples)
    {
        _clock = clock;
        _kinematics = new ToolKinematics(robot);
        Session = new CompensationSession(settings, robot, clock);
        Log = new DemoLog(samples);
        Log.Follow(Session);
    }

    public DisplayFrame Frame { get; private set; }

    public CompensationSession Session { get; }

    public DemoLog Log { get; }

    public ToolPosition Tool => Frame == null ? default : _kinematics.At(Frame.Joints);

    public ToolPosition HeldTool => Frame == null ? default : _kinematics.At(Frame.HeldJoints);

    /// <summary>Always 0, because only scenes raise alarms.</summary>
    public int Alarms => 0;

    public void ReportGpuTime(TimeSpan length) => Session.Rendered(length, RenderTimeSourceKind.DisplayGpuTime);

    public void Step(double seconds) => Frame = Session.Tick(_clock.Now);

    public void Dispose() => Session.Dispose();
}
