using System.CommandLine;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.MotionRecordings;
using Spectre.Console;

namespace Nowpose.Cli.Replay;

/// <summary><c>replay FILE</c>: predicts a recorded motion or session as the headset does, in virtual time and without a network.</summary>
static class ReplayVerb
{
    const double MsPerSecond = 1000;
    const string FramesOption = "--frames";

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
        var phases = NumberOption.Create(
            "--phases", "Number of start phases of the frames, over which the errors of a motion are averaged", 1, 1, 1000, "");
        var predictor = PredictorOption.Create();
        var latencyError = NumberOption.Create("--latency-error-ms", "Error of the latency, added to the time for which positions are predicted", 0.0, -10000, 10000, "ms");
        var stampError = NumberOption.Create("--stamp-error-ms", "Maximum error of each t_k, uniformly distributed around zero", 0.0, 0, 10000, "ms");
        var jitter = NumberOption.Create("--jitter-ms", "Maximum additional delay, uniformly distributed from 0", 0.0, 0, 10000, "ms");
        var loss = NumberOption.Create("--loss", "Probability that a sample is lost", 0.0, 0, 1, "");
        var blend = NumberOption.Create("--blend-ms", "Time constant of the blend from the old section to a new one; a session defines it", 0.0, 0, 200, "ms");
        var seed = NumberOption.Create("--seed", "Seed of the random numbers", 1, int.MinValue, int.MaxValue, "");
        var frames = TextOption.Create(FramesOption, "CSV file for the true, held and predicted values of each axis and object in each scored frame");
        var json = SwitchOption.Create("--json", "Print JSON instead of a table");

        var verb = new Command("replay", "Predict a recorded motion or session in virtual time and without a network, and print the errors.")
        {
            file, sampling, latency, fps, phases, predictor, latencyError, stampError, jitter, loss, blend, seed, frames, json
        };
        verb.SetAction((parsed, cancellation) =>
        {
            var path = parsed.GetRequiredValue(file);
            if (RecordingText.IsSession(path)) RecordingOptions.RequireUnsetForSession(parsed, path, sampling, latency, fps, phases, jitter, loss);
            var settings = new ReplaySettings
            {
                SamplingInterval = parsed.GetValue(sampling) / MsPerSecond,
                Latency = parsed.GetValue(latency) / MsPerSecond,
                FrameRateHz = parsed.GetValue(fps),
                Phases = parsed.GetValue(phases),
                Predictor = parsed.GetValue(predictor),
                LatencyError = parsed.GetValue(latencyError) / MsPerSecond,
                StampError = parsed.GetValue(stampError) / MsPerSecond,
                Jitter = parsed.GetValue(jitter) / MsPerSecond,
                Loss = parsed.GetValue(loss),
                Blend = parsed.IsGiven(blend) ? parsed.GetValue(blend) / MsPerSecond : null,
                Seed = parsed.GetValue(seed)
            };
            var isDefault = !parsed.IsGiven(predictor);
            return RunAsync(path, settings, parsed.GetValue(frames), parsed.GetValue(json), isDefault, cancellation);
        });
        return verb;
    }

    /// <param name="frames">Path of the file for the values of each frame; null to write none.</param>
    /// <param name="isDefault">Whether the predictor was not given.</param>
    static async Task<int> RunAsync(string path, ReplaySettings settings, string frames, bool json, bool isDefault, CancellationToken cancellation)
    {
        if (frames != null) RequireFrames(frames, path);
        if (RecordingText.IsSession(path))
        {
            var session = await Invocation.ReadAsync(() => RecordedSession.Read(path), cancellation);
            List<string> warnings = [.. session.Warnings()];
            // The session was displayed with another predictor than the default one.
            if (isDefault && session.Header.Prediction.Predictor is var own && own != settings.Predictor) warnings.Add(ReplayMessages.OtherPredictor(own));
            foreach (var warning in warnings) await Console.Error.WriteLineAsync(ConsoleMessages.Line($"{path}: {warning}"));
            var result = WithFrames(frames, SessionReplay.AxesOf(session), table => WithProgress("events", 2 * session.Events.Count,
                report => RunSession(path, session, settings, report, cancellation, table)));
            if (result.Frames == 0 && !cancellation.IsCancellationRequested && session.Events.Any(one => one.Kind == RecordedSession.EventKind.Sample))
            {
                warnings.Add(SessionReplay.NothingScored);
                await Console.Error.WriteLineAsync(ConsoleMessages.Line($"{path}: {warnings[^1]}"));
            }
            Print(result, json, cancellation.IsCancellationRequested, ReplayConditions.Of(settings, session.Header.Prediction), warnings);
            return ExitStatus.Done;
        }
        var recording = await Invocation.ReadAsync(() => MotionRecording.Read(path), cancellation);
        string[] ofMotion = RowInterval.WarningOf(recording, settings.SamplingInterval * MsPerSecond) is { } coarse ? [coarse] : [];
        T Replay<T>(
            IReadOnlyList<(string Name, string Unit)> axes,
            Func<Action<ScoredValue>, (int Frames, Func<Action<int>, CancellationToken, T> Run)> create)
        {
            var result = WithFrames(frames, axes, table =>
            {
                var (total, run) = create(table == null ? null : table.Write);
                return WithProgress("frames", total, report => run(report, cancellation));
            });
            // Only after the replay, because invalid input gives only one line.
            foreach (var warning in ofMotion)
                Console.Error.WriteLine(ConsoleMessages.Line($"{path}: {warning}"));
            return result;
        }
        if (recording.IsBody)
            Print(Replay<BodyReplayResult>(BodyReplay.Axes, scored =>
            {
                var replay = new BodyReplay(path, recording, settings) { Scored = scored };
                return (replay.Frames, replay.Run);
            }), json, cancellation.IsCancellationRequested, ReplayConditions.Of(settings), ofMotion);
        else
            Print(Replay<ReplayResult>(ReplayRun.AxesOf(recording), scored =>
            {
                var replay = new ReplayRun(path, recording, settings) { Scored = scored };
                return (replay.Frames, replay.Run);
            }), json, cancellation.IsCancellationRequested, ReplayConditions.Of(settings), ofMotion);
        return ExitStatus.Done;
    }

    static void RequireFrames(string frames, string input)
    {
        OptionPath.RequireNoInput(FramesOption, [frames], input);
        if (frames.EndsWith(".gz", StringComparison.OrdinalIgnoreCase))
            throw new InputException(OptionValueMessages.NotCompressed(FramesOption, frames));
    }

    /// <summary>Calls a replay with the file for the values of each frame, or with null without a file.</summary>
    static T WithFrames<T>(string path, IReadOnlyList<(string Name, string Unit)> axes, Func<FrameTable, T> replay)
    {
        if (path == null) return replay(null);
        T result = default;
        OptionPath.Write(FramesOption, path, () => OutputFile.Write(path, (TextWriter file) =>
        {
            var table = new FrameTable(file, axes);
            table.WriteHeader();
            result = replay(table);
        }));
        return result;
    }

    /// <param name="isInterrupted">Whether the user ended the replay, so that the result is partial.</param>
    /// <param name="conditions">The conditions of the result, for JSON.</param>
    /// <param name="warnings">Reasons why the result can mislead a reader, for JSON; null if there are none. They are already on stderr.</param>
    internal static void Print(
        ReplayResult result, bool json, bool isInterrupted, object conditions = null, IReadOnlyCollection<string> warnings = null)
    {
        if (json) Console.Out.WriteLine(ReplayJson.Of(result, [.. Notes(isInterrupted), .. warnings ?? []], conditions));
        else Write(console => ReplayTable.Write(console, result), isInterrupted);
    }

    /// <inheritdoc cref="Print(ReplayResult, bool, bool, object, IReadOnlyCollection{string})"/>
    internal static void Print(
        BodyReplayResult result, bool json, bool isInterrupted, object conditions = null, IReadOnlyCollection<string> warnings = null)
    {
        if (json) Console.Out.WriteLine(ReplayJson.Of(result, [.. Notes(isInterrupted), .. warnings ?? []], conditions));
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
    /// <param name="frames">Receives the values of each scored frame; null if it is not needed.</param>
    internal static ReplayResult RunSession(
        string path, RecordedSession session, ReplaySettings settings, Action<int> report, CancellationToken cancellation, FrameTable frames = null)
    {
        var bodies = new SessionBodies(session, settings) { Scored = frames == null ? null : frames.WriteObject }.Run(report, cancellation);
        var joints = new ReplayResult(path, settings.Predictor, 0, []);
        var replay = new SessionReplay(path, session, new SessionTruth(session), settings) { Scored = frames == null ? null : frames.Write };
        try
        {
            joints = replay.Run(done => report(session.Events.Count + done), cancellation);
        }
        catch (Exception end) when (end is OperationCanceledException or InputException && bodies.Count > 0 && !replay.HasScored)
        {
            // Keeps the results of the objects, which are replayed first. A cell may have objects and no robot.
        }
        return joints with { Bodies = bodies, Signals = session.Signals };
    }
}
