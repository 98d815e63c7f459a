using System.Diagnostics;
using Nowpose.Cli.Demo;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Robots;
using Nowpose.Kinematics;
using Nowpose.Recording;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>The headset runtime against a gateway that is there already, at a display's pace, without a display.</summary>
sealed class HeadsetRun(HeadsetSettings settings)
{
    static readonly TimeSpan DescriptionTimeout = TimeSpan.FromSeconds(10);

    readonly StopwatchHeadsetClock _clock = new();
    readonly PoseCount _poses = new();
    TimeSpan? _synchronisedAfter;
    int _frames;

    /// <exception cref="InputException">No robot is known.</exception>
    public HeadsetResult Play(Action<double, Func<string>> report, CancellationToken cancel)
    {
        var robot = settings.Robot == null ? DescribedRobot(cancel) : RobotFiles.Load(settings.Robot);
        using var session = Open(robot);
        var recorder = settings.RecordingPath == null
            ? null : new SessionRecorder(session, new RecordingSettings(settings.RecordingPath, startedUtc: DateTime.UtcNow));
        session.Connect();
        var start = _clock.Now;
        Frames(session, start, report, cancel);
        recorder?.Dispose();
        recorder?.Ended.Wait(CancellationToken.None);
        if (recorder?.Problem is string problem) Console.Error.WriteLine("nowpose: " + problem);
        return Result(session, robot, _clock.Now - start);
    }

    /// <summary>Why nothing can be said of the run; null when something can.</summary>
    public static string Failure(HeadsetResult result, CompensationSession session) => result switch
    {
        { Clock.SynchronisedAfterS: null } => $"the clock was never synchronised: {session.SyncLink.Detail}",
        { Samples: 0 } => $"no joint positions arrived: {session.SampleLink.Detail}",
        _ => null,
    };

    /// <summary>Set once it was played.</summary>
    public string WhyFailed { get; private set; }

    void Frames(CompensationSession session, HeadsetTime start, Action<double, Func<string>> report, CancellationToken cancel)
    {
        var startCount = Stopwatch.GetTimestamp();
        var count = (int)(settings.Seconds * settings.FramesPerSecond);
        for (; _frames < count && !cancel.IsCancellationRequested; _frames++)
        {
            // By its number, never by adding: a frame that was late must not push all the others back.
            PreciseWait.Until(startCount + (long)(_frames / settings.FramesPerSecond * Stopwatch.Frequency));
            var now = _clock.Now;
            var frame = session.Tick(now);
            _poses.Add(now - start, frame.State);
            if (_synchronisedAfter == null && session.Clock.ModelAt(now).State == ClockState.Synchronised)
            {
                _synchronisedAfter = now - start;
                session.RestartErrorRun();
            }

            report((now - start).TotalSeconds, () => DemoProgress.Describe(session, _clock.Now));
        }
    }

    // What a robot is named by decides how it is read: one from the gateway needs a session that asks for it first.
    RobotModel DescribedRobot(CancellationToken cancel)
    {
        using var session = Open(RobotFiles.Load("youbot"));
        session.Connect();
        var since = _clock.Now;
        while (session.DescribedRobot == null)
        {
            cancel.ThrowIfCancellationRequested();
            if (_clock.Now - since > DescriptionTimeout)
                throw new InputException(
                    $"--robot: missing, and the gateway described none within {DescriptionTimeout.TotalSeconds} s "
                    + $"({session.RobotDescriptionFault ?? session.SampleLink.Detail}); name youbot, ur5 or a .urdf file");
            Thread.Sleep(5);
        }

        return session.DescribedRobot;
    }

    CompensationSession Open(RobotModel robot) => new(
        new SessionSettings(settings.Connection, settings.Visualisation, new PredictionSettings(settings.Predictor)), robot, _clock);

    HeadsetResult Result(CompensationSession session, RobotModel robot, TimeSpan length)
    {
        var statistics = session.Statistics(_clock.Now);
        var clock = statistics.Clock;
        var error = statistics.ToolErrorOfRun;
        var result = new HeadsetResult(
            length.TotalSeconds, _frames, robot.Name, statistics.Samples, statistics.Dropped,
            new HeadsetResult.ClockResult(
                clock.State.Word(), clock.IsKnown ? clock.ErrorBound.TotalMicroseconds : null, clock.IsKnown ? clock.Skew * 1e6 : null,
                statistics.RoundTripTime?.TotalMilliseconds, statistics.ClockSteps, _synchronisedAfter?.TotalSeconds),
            new HeadsetResult.LatencyResult(
                statistics.ApplicationLatency?.TotalMilliseconds, statistics.ApplicationLatency95?.TotalMilliseconds,
                statistics.VisualisationLatency.TotalMilliseconds, statistics.EndToEndLatency?.TotalMilliseconds),
            _poses.Result(),
            error is not { } of ? null : new HeadsetResult.ErrorResult(
                of.HoldRms, of.HoldP95, of.Rms, of.P95, of.Reduction, of.ReductionUncertainty));
        WhyFailed = Failure(result, session);
        return result;
    }
}
