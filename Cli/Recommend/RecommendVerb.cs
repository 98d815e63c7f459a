using System.CommandLine;
using Nowpose.Cli.Replay;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Recommend;

/// <summary><c>recommend FILE</c>: recommends a predictor for a user's recording.</summary>
static class RecommendVerb
{
    static readonly (double SamplingMs, double LatencyMs)[] Grid = [(20, 100), (50, 100), (100, 150)];

    public static Command Create()
    {
        var file = new Argument<string>("FILE")
        {
            Description = "A motion (.csv or .csv.gz) in the format of replay; or a recorded session (.jsonl or .jsonl.gz), evaluated with its own "
                + "samples, latencies and frames.",
        };
        var sampling = NumberOption.Create("--sampling-ms", "Sampling interval T_s of a motion", 50.0, 0.1, 10000, "ms");
        var latency = NumberOption.Create("--latency-ms", "Latency L, from the time of a sample to its arrival", 100.0, 0, 10000, "ms");
        var grid = SwitchOption.Create("--grid", "Evaluate a motion at 20/100, 50/100 and 100/150 ms (T_s/L) instead");
        var json = SwitchOption.Create("--json", "Print JSON instead of tables");
        var verb = new Command(
            "recommend", "Evaluate all predictors, and polynomials with other histories, on both halves of a recording, and recommend one.")
        {
            file, sampling, latency, grid, json,
        };
        verb.SetAction((parsed, cancel) =>
        {
            var path = parsed.GetRequiredValue(file);
            if (RecordingText.IsSession(path)) RecordingOptions.RequireUnsetForSession(parsed, path, sampling, latency, grid);
            else if (parsed.GetValue(grid)) RecordingOptions.RequireUnset(parsed, RecommendMessages.GridSets, sampling, latency);
            (double, double)[] conditions = parsed.GetValue(grid) ? Grid : [(parsed.GetValue(sampling), parsed.GetValue(latency))];
            return RunAsync(path, conditions, parsed.GetValue(json), cancel);
        });
        return verb;
    }

    static async Task<int> RunAsync(string path, (double SamplingMs, double LatencyMs)[] conditions, bool json, CancellationToken cancel)
    {
        var recording = await Invocation.ReadAsync(() => RecordingText.IsSession(path) ? OfSession(path) : OfMotion(path, conditions), cancel);
        var evaluation = new CandidateEvaluation(recording.Subjects);
        ConsoleProgress.Run("trying predictors", "runs", evaluation.Runs, report => evaluation.Run(report, cancel));
        var recommendations = evaluation.Recommendations();
        var results = new List<(Recommendation, BlendCost)>();
        var runs = 0;
        ConsoleProgress.Run("trying the blend", "runs", BlendCost.Runs * recommendations.Count, report => results.AddRange(
            recommendations.Select(recommendation => (recommendation, new BlendCost(recommendation, () => report(++runs), cancel)))));
        var all = evaluation.Runs + BlendCost.Runs * recording.Subjects.Length;
        string[] warnings = [.. WarningsOf(recording.Session, evaluation.Done + runs, all), .. recording.Traits.Warnings()];
        if (json) Console.Out.WriteLine(RecommendJson.Of(path, recording.Traits, warnings, results));
        else RecommendTable.Write(ResultConsole.Create(), path, recording.Traits, warnings, results);
        return ExitStatus.Done;
    }

    /// <summary>Gets the warnings that the evaluation or the recording is incomplete.</summary>
    /// <param name="session">The session; null for a motion.</param>
    /// <param name="done">Number of finished runs; smaller than <paramref name="all"/> only after Ctrl-C.</param>
    internal static IEnumerable<string> WarningsOf(RecordedSession session, int done, int all)
    {
        if (done < all) yield return RecommendMessages.Interrupted(done, all);
        foreach (var warning in session?.Warnings() ?? []) yield return warning;
    }

    static (RecordingTraits Traits, ISubject[] Subjects, RecordedSession Session) OfMotion(
        string path, (double SamplingMs, double LatencyMs)[] conditions)
    {
        var motion = MotionRecording.Read(path);
        if (motion.IsBody)
            throw new InputException(RecommendMessages.RigidBody(path));
        var joints = motion.Names.Select((name, joint) => new JointSeries(name, motion.Times, motion.PositionsOf(joint)));
        var subjects = conditions.Select(c => new MotionSubject(path, motion, c.SamplingMs, c.LatencyMs));
        return (new RecordingTraits([.. joints], conditions.Min(c => c.SamplingMs)), [.. subjects], null);
    }

    static (RecordingTraits Traits, ISubject[] Subjects, RecordedSession Session) OfSession(string path)
    {
        var session = RecordedSession.Read(path);
        return (new RecordingTraits(SessionSeries.Of(session)), [new SessionSubject(path, session)], session);
    }
}
