using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Records a session of a virtual cell in virtual time to a file, and computes its errors against the simulated truth.</summary>
sealed class VirtualRecording
{
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);

    /// <summary>Sum of the squared errors of the displayed positions of all joints, in the current frames after six seconds.</summary>
    public double DisplayedSquares { get; private set; }

    /// <summary>Sum of the squared errors of the held positions of all joints, in the same frames.</summary>
    public double HeldSquares { get; private set; }

    /// <summary>Every exchange as a line of a log: t1_ns,t2_ns,t3_ns,t4_ns.</summary>
    public List<string> Exchanges { get; } = [];

    /// <summary>Records a session. The control clock steps by 300 ms at the time <paramref name="stepAfter"/> in s.</summary>
    /// <param name="predictor">The predictor, used with <paramref name="blendMs"/> if <paramref name="prediction"/> is null.</param>
    /// <param name="planLagMs">Delay of the robot relative to its published set-points; null to publish no set-points.</param>
    /// <param name="planUntil">Time in s after which no set-points are published.</param>
    /// <param name="hasWork">Whether the robot moves workpieces. The cell then publishes the workpieces and its signals, and the session shows the workpieces.</param>
    /// <param name="jitterMs">Jitter in ms. Samples overtake each other if the jitter exceeds the sampling interval.</param>
    public static VirtualRecording To(
        string path, double seconds = 20, string predictor = "quadratic", double jitterMs = 0, double loss = 0, double? stepAfter = null,
        double blendMs = 0, int seed = 5, double samplingMs = 50, double? planLagMs = null,
        double planUntil = double.PositiveInfinity, PredictionSettings prediction = null, bool hasWork = false)
    {
        var robot = RobotFiles.Load("youbot");
        var result = new VirtualRecording();
        var clock = new VirtualClock(Start, TimeSpan.FromSeconds(1_700_000_000), 37e-6);
        var settings = new VirtualCellSettings(samplingMs, 55, 105, jitterMs, loss, NetworkProfile.Wifi);
        var motion = new PickAndPlaceMotion(robot);
        var motions = hasWork ? new CellMotion(new CellWork(robot, motion)) : new CellMotion(motion);
        var cell = new VirtualCell(motions, clock, settings, seed, Start);
        if (planLagMs.HasValue) cell.PlanLag = TimeSpan.FromMilliseconds(planLagMs.Value);
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(Visualisation),
                prediction ?? new PredictionSettings(predictor, blendMs: blendMs)),
            robot, new StopwatchHeadsetClock());
        session.Clock.Judged += (in SyncExchange e, SyncVerdict _, SyncExchangeFault _) =>
            result.Exchanges.Add(FormattableString.Invariant($"{e.T1.Nanoseconds},{e.T2.Nanoseconds},{e.T3.Nanoseconds},{e.T4.Nanoseconds}"));
        foreach (var name in motions.Work?.Names ?? []) session.Frames.Need(name);
        using (var recorder = new SessionRecorder(session, new RecordingSettings(path)))
        {
            for (var i = 0; i < seconds * 60; i++)
            {
                var now = Start + TimeSpan.FromTicks((long)(i / 60.0 * TimeSpan.TicksPerSecond));
                if (i / 60.0 >= stepAfter) clock.Set(now, TimeSpan.FromSeconds(1_700_000_000.3), 37e-6);
                if (i / 60.0 >= planUntil) cell.PlanLag = null;
                cell.Run(now, session);
                result.Score(session.Tick(now), cell, i > 360);
                // The ring buffer holds the lines of ten seconds.
                if (i % 240 == 0) recorder.FlushAsync().Wait();
            }
            recorder.Dispose();
            recorder.Ended.Wait();
            if (recorder.Problem != null || recorder.LostLines > 0) throw new IOException(recorder.Problem ?? recorder.LostLines + " lines lost");
        }
        return result;
    }

    void Score(DisplayFrame frame, VirtualCell cell, bool isScored)
    {
        if (!isScored || frame.State != PoseState.Current) return;
        Span<double> truth = stackalloc double[frame.Joints.Length];
        cell.TruthAt(frame.Start + Visualisation, truth);
        for (var joint = 0; joint < truth.Length; joint++)
        {
            DisplayedSquares += Math.Pow(frame.Joints[joint] - truth[joint], 2);
            HeldSquares += Math.Pow(frame.HeldJoints[joint] - truth[joint], 2);
        }
    }
}
