using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Recording;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Runs the headset runtime without a display against an existing gateway, at the frame rate of a display.</summary>
/// <param name="say">
/// Receives a line of text when the pose stops being current, when it becomes current again, and when the recording ends early.
/// </param>
sealed class HeadsetRun(HeadsetSettings settings, Action<string> say)
{
    static readonly RobotModel Placeholder = UrdfReader.Read("<robot name='none'><link name='base'/></robot>", "no robot");

    readonly StopwatchHeadsetClock _clock = new();
    readonly PoseCount _poses = new();
    readonly PoseStretches _stretches = new();
    readonly PoseOutages _outages = new(say);
    TimeSpan? _coarseAfter, _synchronisedAfter;
    bool _wasTimeTrusted, _wasCurrent;
    int _frames;
    CellParts _parts;

    /// <exception cref="InputException">The recording cannot be written.</exception>
    public HeadsetResult Play(Action<double, Func<string>> report, CancellationToken cancel)
    {
        var isNewFile = settings.RecordingPath != null && !Path.Exists(settings.RecordingPath);
        // Opens the recording before the run, so that a wrong path is reported at once.
        using var file = settings.RecordingPath == null ? null : OptionPath.Open("--record", settings.RecordingPath);
        HeadsetResult undescribed = null;
        var robot = settings.Robot ?? DescribedRobot(cancel, out undescribed);
        if (robot == null)
        {
            // Nothing was recorded. An earlier recording is kept.
            if (isNewFile) File.Delete(settings.RecordingPath);
            return undescribed;
        }
        using var session = Open(robot);
        var recorder = file == null ? null : new SessionRecorder(
            session, new RecordingSettings(settings.RecordingPath, () => Emptied(file), settings.RecordingMegabytes, DateTime.UtcNow));
        session.Robots[0].Hindcast.ToolJudged += _stretches.AddError;
        _parts = new CellParts(session);
        session.Connect();
        var start = _clock.Now;
        Frames(session, recorder, start, report, cancel);
        recorder?.Dispose();
        recorder?.Ended.Wait(CancellationToken.None);
        RecordingFault = recorder == null ? null : HeadsetVerdict.RecordingFaultOf(recorder.Problem, recorder.LostLines);
        var result = Result(session, robot, _clock.Now - start);
        var statistics = session.Statistics(_clock.Now);
        if (statistics.Samples > 0) Notes = [.. HeadsetVerdict.NotesOf(statistics).Select(note => RobotMessages.OfRobot(robot.Name, note))];
        WhyFailed = HeadsetVerdict.FailureOf(
            result.Pose, statistics, _wasTimeTrusted, result.Outages, HeadsetVerdict.BaseFaultOf(session, _clock.Now));
        return result;
    }

    /// <summary>Reason why the gateway and its plant are not suitable, in one line; null if they are. Set by <see cref="Play"/>.</summary>
    public string WhyFailed { get; private set; }

    /// <summary>Reason why the recording is incomplete, in one line; null if it is complete or not requested. Set by <see cref="Play"/>.</summary>
    public string RecordingFault { get; private set; }

    /// <summary>Reasons why the pose may be wrong although it is current, in one line each. Set by <see cref="Play"/>.</summary>
    public IReadOnlyList<string> Notes { get; private set; } = [];

    public bool HasFailed => WhyFailed != null || RecordingFault != null;

    // The recorder is null without a recording.
    void Frames(
        CompensationSession session, SessionRecorder recorder, HeadsetTime start, Action<double, Func<string>> report, CancellationToken cancel)
    {
        var startCount = Stopwatch.GetTimestamp();
        var count = (int)(settings.Seconds * settings.FramesPerSecond);
        var isStopReported = false;
        for (; _frames < count && !cancel.IsCancellationRequested; _frames++)
        {
            // Computes the time from the frame's number, so that a late frame does not delay the following ones.
            PreciseWait.Until(startCount + (long)(_frames / settings.FramesPerSecond * Stopwatch.Frequency));
            var now = _clock.Now;
            var frame = session.Tick(now);
            _parts.Update();
            Count(now - start, frame, session);
            if (!isStopReported && recorder?.Problem is { } problem)
            {
                isStopReported = true;
                say(HeadsetMessages.RecordingStopped((now - start).TotalSeconds, problem));
            }
            if (frame.ClockState is ClockState.Coarse or ClockState.Synchronised) _coarseAfter ??= now - start;
            if (frame.ClockState == ClockState.Synchronised) _synchronisedAfter ??= now - start;
            report((now - start).TotalSeconds, () => ConsoleProgress.Describe(session, _clock.Now));
        }
    }

    void Count(TimeSpan time, DisplayFrame frame, CompensationSession session)
    {
        _poses.Add(time, frame.State);
        _outages.Add(time, frame.State == PoseState.Current, () => Describe(session));
        _stretches.Add(time, frame.State, frame.DisplayTime, _outages.IsOutage);
        _wasTimeTrusted |= frame.IsTimeTrusted;
        if (_wasCurrent || frame.State != PoseState.Current) return;
        _wasCurrent = true;
        // Restarts the error statistics, so that those in a recording start with the first current frame.
        session.RestartErrorRun();
    }

    (string Pose, IReadOnlyList<string> Joints, string Reason) Describe(CompensationSession session)
    {
        var statistics = session.Statistics(_clock.Now);
        var missing = statistics.JointStatuses.Where(joint => joint.IsMissing).ToList();
        return (
            PoseStateName.Of(statistics), [.. missing.Select(joint => joint.Joint)],
            HeadsetVerdict.ReasonOf(statistics, missing, HeadsetVerdict.BaseFaultOf(session, _clock.Now)));
    }

    // Gets the robot from the gateway. If the gateway does not describe it in time, returns null, and the result of the connections alone.
    RobotModel DescribedRobot(CancellationToken cancel, out HeadsetResult undescribed)
    {
        // A session cannot be created without a robot. This one only waits for the description.
        using var session = Open(Placeholder);
        session.Connect();
        var start = _clock.Now;
        while (session.DescribedRobot == null && !cancel.IsCancellationRequested && _clock.Now - start <= settings.DescriptionTimeout)
            Thread.Sleep(5);
        undescribed = null;
        if (session.DescribedRobot is { } robot) return robot;
        undescribed = Result(session, null, _clock.Now - start);
        WhyFailed = session.Robots[0].OtherNamespaces is { } fault
            ? HeadsetMessages.OtherNamespaces(fault)
            : HeadsetMessages.NoRobot(settings.DescriptionTimeout.TotalSeconds, DescriptionFaultOf(session), settings.RobotNamespace);
        return null;
    }

    static string DescriptionFaultOf(CompensationSession session) =>
        session.RobotDescriptionFault ?? (session.SampleLink.State == LinkState.Connected ? null : session.SampleLink.Detail);

    // An earlier recording is kept until the new one begins.
    static FileStream Emptied(FileStream file)
    {
        // A device such as /dev/null has no length and cannot be shortened.
        if (file.CanSeek && file.Length > 0) file.SetLength(0);
        return file;
    }

    CompensationSession Open(RobotModel robot) => new(settings.Session, robot, _clock);

    // The robot is null if it is not known.
    HeadsetResult Result(CompensationSession session, RobotModel robot, TimeSpan length)
    {
        var now = _clock.Now;
        var statistics = session.Statistics(now);
        var clock = statistics.Clock;
        var pose = _poses.Result(PoseStateName.Of(statistics));
        var (objects, signals) = _parts?.NotCurrent(now) ?? ([], []);
        return new HeadsetResult(
            length.TotalSeconds, _frames, robot?.Name, statistics.Samples, statistics.Dropped,
            new HeadsetResult.ClockResult(
                clock.State.Word(), clock.IsKnown ? clock.ErrorBound.TotalMicroseconds : null, clock.IsKnown ? clock.Skew * 1e6 : null,
                statistics.RoundTripTime?.TotalMilliseconds, statistics.ClockSteps, _coarseAfter?.TotalSeconds, _synchronisedAfter?.TotalSeconds,
                clock.IsKnown ? clock.OffsetAt(now).HeadsetMinusControl.Ticks * ClockTicks.NanosecondsPerTick : null,
                clock.IsKnown ? clock.EstimatedError.TotalMicroseconds : null, now.Nanoseconds),
            new HeadsetResult.LatencyResult(
                statistics.ApplicationLatency?.TotalMilliseconds, statistics.ApplicationLatency95?.TotalMilliseconds,
                statistics.VisualisationLatency.TotalMilliseconds, statistics.EndToEndLatency?.TotalMilliseconds),
            pose, _stretches.Total,
            [.. statistics.JointStatuses.Where(joint => joint.IsMissing).Select(joint => joint.Joint)],
            [.. statistics.JointStatuses.Select(HeadsetResult.JointResult.Of)], _stretches.Result(), _outages.Result(), _outages.NotListed,
            objects, signals, _parts?.NotFollowed() ?? [], statistics.VersionMismatch);
    }
}
