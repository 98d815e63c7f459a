using System.CommandLine;
using Nowpose.Cli.Messages;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.MotionRecordings;
using Spectre.Console;

namespace Nowpose.Cli.Replay;

/// <summary><c>replay FILE</c>: predicts a recorded motion or session as the headset does, in virtual time and without a network.</summary>
static class ReplayVerb
{
    const double MsPerSecond = 1000;

    public static Command Create()
    {
        var file = new Argument<string>("FILE")
        {
            Description = "A motion (.csv or .csv.gz): header, time in seconds named t or t_s, then one column per joint, "
                + "or a rigid body with the header t_s,x,y,z,qx,qy,qz,qw (m, unit quaternion). Or a session "
                + "(.jsonl or .jsonl.gz), which contains sampling, latency and frames; cubics through its samples are then the true motion."
        };
        var sampling = NumberOption.Create("--sampling-ms", "Sampling interval T_s", 50.0, 0.1, 10000, "ms");
        var latency = NumberOption.Create("--latency-ms", "Latency L, from the time of a sample to its arrival", 100.0, 0, 10000, "ms");
        var fps = NumberOption.Create("--fps", "Frames per second", 60.0, 1, 1000, "");
        var predictor = PredictorOption.Create();
        var latencyError = NumberOption.Create("--latency-error-ms", "Error of the latency, added to the time for which positions are predicted", 0.0, -10000, 10000, "ms");
        var stampError = NumberOption.Create("--stamp-error-ms", "Maximum error of each t_k, uniformly distributed around zero", 0.0, 0, 10000, "ms");
        var jitter = NumberOption.Create("--jitter-ms", "Maximum additional delay, uniformly distributed from 0", 0.0, 0, 10000, "ms");
        var loss = NumberOption.Create("--loss", "Probability that a sample is lost", 0.0, 0, 1, "");
        var blend = NumberOption.Create("--blend-ms", "Time constant of the blend from the old section to a new one; a session defines it", 0.0, 0, 200, "ms");
        var seed = NumberOption.Create("--seed", "Seed of the random numbers", 1, int.MinValue, int.MaxValue, "");
        var json = SwitchOption.Create("--json", "Print JSON instead of a table");

        var verb = new Command("replay", "Predict a recorded motion or session as on the headset, without a network and in virtual time.")
        {
            file, sampling, latency, fps, predictor, latencyError, stampError, jitter, loss, blend, seed, json
        };
        verb.SetAction((parsed, cancellation) =>
        {
            var path = parsed.GetRequiredValue(file);
            if (RecordingText.IsSession(path)) RecordingOptions.RequireUnsetForSession(parsed, path, sampling, latency, fps, jitter, loss);
            var settings = new ReplaySettings
            {
                SamplingInterval = parsed.GetValue(sampling) / MsPerSecond,
                Latency = parsed.GetValue(latency) / MsPerSecond,
                FrameRateHz = parsed.GetValue(fps),
                Predictor = parsed.GetValue(predictor),
                LatencyError = parsed.GetValue(latencyError) / MsPerSecond,
                StampError = parsed.GetValue(stampError) / MsPerSecond,
                Jitter = parsed.GetValue(jitter) / MsPerSecond,
                Loss = parsed.GetValue(loss),
                Blend = RecordingOptions.IsGiven(parsed, blend) ? parsed.GetValue(blend) / MsPerSecond : null,
                Seed = parsed.GetValue(seed)
            };
            return RunAsync(path, settings, parsed.GetValue(json), cancellation);
        });
        return verb;
    }

    static async Task<int> RunAsync(string path, ReplaySettings settings, bool json, CancellationToken cancellation)
    {
        if (RecordingText.IsSession(path))
        {
            var session = await Invocation.ReadAsync(() => RecordedSession.Read(path), cancellation);
            if (session.Lost > 0) await Console.Error.WriteLineAsync(ConsoleMessages.LostLines(path, session.Lost));
            var result = WithProgress("events", 2 * session.Events.Count, report => RunSession(path, session, settings, report, cancellation));
            if (result.Frames == 0 && !cancellation.IsCancellationRequested && session.Events.Any(one => one.Kind == RecordedSession.EventKind.Sample))
                await Console.Error.WriteLineAsync(ConsoleMessages.Line(SessionReplay.NothingScored(path)));
            Print(result, json, cancellation.IsCancellationRequested);
        }
        else
        {
            var recording = await Invocation.ReadAsync(() => MotionRecording.Read(path), cancellation);
            if (recording.IsBody)
            {
                var replay = new BodyReplay(path, recording, settings);
                var result = WithProgress("frames", replay.Frames, report => replay.Run(report, cancellation));
                WarnOfRows(path, recording, settings);
                Print(result, json, cancellation.IsCancellationRequested);
            }
            else
            {
                var replay = new ReplayRun(path, recording, settings);
                var result = WithProgress("frames", replay.Frames, report => replay.Run(report, cancellation));
                WarnOfRows(path, recording, settings);
                Print(result, json, cancellation.IsCancellationRequested);
            }
        }
        return ExitStatus.Done;
    }

    // Called only after a replay, because invalid input gives only one line.
    static void WarnOfRows(string path, MotionRecording recording, ReplaySettings settings)
    {
        if (RowInterval.WarningOf(recording, settings.SamplingInterval * MsPerSecond) is { } warning)
            Console.Error.WriteLine(ConsoleMessages.Line($"{path}: {warning}"));
    }

    /// <param name="isInterrupted">Whether the user ended the replay, so that the result is partial.</param>
    internal static void Print(ReplayResult result, bool json, bool isInterrupted)
    {
        if (json) Console.Out.WriteLine(ReplayJson.Of(result, Notes(isInterrupted)));
        else Write(console => ReplayTable.Write(console, result), isInterrupted);
    }

    /// <inheritdoc cref="Print(ReplayResult, bool, bool)"/>
    internal static void Print(BodyReplayResult result, bool json, bool isInterrupted)
    {
        if (json) Console.Out.WriteLine(ReplayJson.Of(result, Notes(isInterrupted)));
        else Write(console => ReplayTable.Write(console, result), isInterrupted);
    }

    static void Write(Action<IAnsiConsole> write, bool isInterrupted)
    {
        var console = ResultConsole.Create();
        write(console);
        foreach (var note in Notes(isInterrupted)) console.WriteLine(DemoTexts.Note(note));
    }

    static string[] Notes(bool isInterrupted) => isInterrupted ? [ReplayMessages.Interrupted] : [];

    static T WithProgress<T>(string units, int total, Func<Action<int>, T> replay)
    {
        var result = default(T);
        ConsoleProgress.Run("replaying", units, total, report => result = replay(report));
        return result;
    }

    /// <param name="report">Receives the number of finished events. Each event is replayed twice: for the objects, then for the joints.</param>
    internal static ReplayResult RunSession(
        string path, RecordedSession session, ReplaySettings settings, Action<int> report, CancellationToken cancellation)
    {
        var bodies = new SessionBodies(session, settings).Run(report, cancellation);
        var joints = new ReplayResult(path, settings.Predictor, 0, []);
        var replay = new SessionReplay(path, session, new SessionTruth(session), settings);
        try
        {
            joints = replay.Run(done => report(session.Events.Count + done), cancellation);
        }
        catch (Exception end) when (end is OperationCanceledException or InputException && bodies.Count > 0 && !replay.HasScored)
        {
            // Keeps the results of the objects, which are replayed first. A cell may have objects and no robot.
        }
        return new ReplayResult(joints.File, joints.Predictor, joints.Frames, joints.Axes) { Bodies = bodies, Signals = session.Signals };
    }
}
