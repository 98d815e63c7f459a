using System.CommandLine;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Latency.Sweep;
using Nowpose.Motion;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;

namespace Nowpose.Cli.Demo;

/// <summary>
/// <c>demo</c>, the default command: runs gateway, network, headset runtime and robot in one process and compares the displayed poses with the
/// true ones.
/// </summary>
static class DemoVerb
{
    static readonly Option<double> Seconds = NumberOption.Create("--seconds", "Duration of the run", 20.0, 5, 3600, "s");
    static readonly Option<string> Network = ChoiceOption.Create(
        "--network", "Simulated network between gateway and headset", "wifi", [.. NetworkProfile.All.Select(profile => profile.Name)]);
    static readonly Option<string> Robot = TextOption.Create("--robot", RobotFiles.Names + " or a .urdf file", standard: "youbot");
    static readonly Option<string> Recording = TextOption.Create(
        "--recording", "Recorded motion, played forward and backward: .csv or .csv.gz with the time in s and one column per joint");
    static readonly Option<string> Predictor = PredictorOption.Create();
    static readonly Option<string> Estimator = RuntimeOptions.Estimator();
    static readonly Option<string> Profile = RuntimeOptions.Profile("the display latency and, with --load, the render time limit");
    static readonly Option<double> Sampling = NumberOption.Create(
        "--sampling-ms", "Sampling interval T_s of the control system", 50.0, 1, 1000, "ms");
    static readonly Option<MillisecondRange> Acquisition = RangeOption.Create(
        "--acquisition-ms", "Delay that subscription and middleware add to each sample before it is sent", new MillisecondRange(55, 105), 1000);
    static readonly Option<double> Visualisation = NumberOption.Create(
        "--visu-ms", "True display latency of the simulated headset", 40.0, 0, 400, "ms");
    static readonly Option<double> VisualisationError = NumberOption.Create(
        "--visu-error-ms", "Error of the display latency that the runtime uses", 0.0, -100, 100, "ms");
    static readonly Option<int?> Load = NumberOption.CreateOptional(
        "--load", "Number of vertices to render between one third and three quarters of the run", 0, SweepPlan.MaxVertices, "vertices");
    static readonly Option<bool> Trajectory = SwitchOption.Create("--trajectory", "Also publish the cell's set-points ahead of time");
    static readonly Option<int> Seed = NumberOption.Create("--seed", "Seed of the random numbers", 1, 0, 1_000_000, "");
    static readonly Option<bool> Paper = SwitchOption.Create(
        "--paper", "Reproduce Sect. 3 of the paper: its swing, clock and predictor, a display calibrated by pictures, and a verdict on each claim "
            + $"of Figs 8, 16, 17 and 18; runs {PaperScenario.Seconds} s by default");
    static readonly Option<bool> Virtual = SwitchOption.Create(
        "--virtual", "Compute the run in virtual time, without sockets and without the scene: the results depend only on the settings and the seed");
    static readonly Option<int> Repeats = NumberOption.Create(
        "--repeats", "Number of runs of --paper, from which the uncertainty is computed, or of --virtual, each with the next seed", 1, 1, 100, "");
    static readonly Option<string> Output = TextOption.Create(
        "--out", "Folder for report.html, result.json, session.jsonl, and, with --paper, the data of figures, frames and exchanges",
        standard: "nowpose-demo");

    static readonly Option<bool> Open = Browser.Option();

    /// <summary>Minimum sampling interval of a virtual cell.</summary>
    const double MinVirtualSamplingMs = 5;

    // With a load, L_visu is at least one refresh interval: a frame is displayed at the next refresh at the earliest.
    const double MinWithLoadMs = 17;

    public static Command Create()
    {
        var verb = new Command(
            "demo", "Run the headset runtime with a simulated cell over real sockets, and compare the displayed poses with the true ones.")
        {
            Seconds, Network, Robot, Recording, Predictor, Estimator, Profile, Sampling, Acquisition, Visualisation,
            VisualisationError, Load, Trajectory, Seed, Virtual, Paper, Repeats, Output, Open,
        };
        verb.SetAction(RunAsync);
        return verb;
    }

    static async Task<int> RunAsync(ParseResult parsed, CancellationToken cancel)
    {
        var folder = parsed.GetValue(Output);
        var isPaper = parsed.GetValue(Paper);
        if (parsed.GetValue(Virtual)) RequireVirtual(parsed);
        var settings = await Invocation.ReadAsync(() => isPaper ? PaperSettings(parsed) : Settings(parsed), cancel);
        var status = await (isPaper
            ? PaperSession.RunAsync(settings, parsed.GetValue(Repeats), folder, cancel) : RunAsync(settings, parsed, folder, cancel));
        if (parsed.GetValue(Open) && status == ExitStatus.Done) Browser.OpenOrExplain(DemoOutput.ReportIn(Path.GetFullPath(folder)));
        return status;
    }

    static DemoSettings PaperSettings(ParseResult parsed)
    {
        Option[] other =
        [
            .. Others(parsed, Robot, PaperScenario.Robot), .. Others(parsed, Recording), .. Others(parsed, Predictor, PaperScenario.Predictor),
            .. Others(parsed, Estimator, PaperScenario.Estimator), .. Others(parsed, Profile), .. Others(parsed, Sampling, PaperScenario.SamplingMs),
            .. Others(parsed, Load), .. Others(parsed, Trajectory),
        ];
        if (other.Length > 0)
            throw new InputException(DemoMessages.NotWithPaper(string.Join(", ", other.Select(option => option.Name))));
        var seconds = parsed.IsGiven(Seconds) ? parsed.GetValue(Seconds) : PaperScenario.Seconds;
        if (seconds < PaperScenario.MinSeconds)
            throw new InputException(DemoMessages.PaperSeconds(seconds, PaperScenario.MinSeconds));
        return Settings(parsed) with { Seconds = seconds };
    }

    // Returns the option if the user gave it a value other than the paper's value.
    static IEnumerable<Option> Others<T>(ParseResult parsed, Option<T> option, T papers = default) =>
        parsed.IsGiven(option) && !EqualityComparer<T>.Default.Equals(parsed.GetValue(option), papers) ? [option] : [];

    internal static DemoSettings Settings(ParseResult parsed)
    {
        var assumed = parsed.GetValue(Visualisation) + parsed.GetValue(VisualisationError);
        if (assumed is < 0 or > 500)
            throw new InputException(DemoMessages.AssumedVisu(assumed));
        var renders = parsed.GetValue(Paper) ? Paper.Name : parsed.GetValue(Load) != null ? Load.Name : null;
        if (renders != null && parsed.GetValue(Visualisation) < MinWithLoadMs)
            throw new InputException(DemoMessages.VisuWithLoad(parsed.GetValue(Visualisation), renders, MinWithLoadMs));
        if (parsed.IsGiven(Repeats) && !parsed.GetValue(Paper) && !parsed.GetValue(Virtual))
            throw new InputException(DemoMessages.RepeatsAlone);
        var robot = RobotFiles.Load(parsed.GetValue(Robot), out var urdf);
        var recording = parsed.GetValue(Recording) is { } path ? MotionRecording.Read(path) : null;
        var motion = recording == null ? null : new RecordedMotion(recording, robot);
        return new DemoSettings
        {
            Seconds = parsed.GetValue(Seconds),
            Network = NetworkProfile.Named(parsed.GetValue(Network)),
            Robot = robot,
            RobotText = urdf,
            Motion = recording == null
                ? new CellMotion(new CellWork(robot, new PickAndPlaceMotion(robot)))
                : new CellMotion(motion),
            MotionName = recording == null
                ? DemoTexts.PickAndPlace : DemoTexts.Recording(Path.GetFileName(recording.Source)),
            MotionWarnings = recording == null ? [] : WarningsOf(recording, motion, parsed.GetValue(Sampling)),
            Predictor = parsed.GetValue(Predictor),
            Estimator = parsed.GetValue(Estimator),
            Profile = RuntimeOptions.ProfileOf(parsed, Profile, VisualisationError),
            SamplingMs = parsed.GetValue(Sampling),
            Acquisition = parsed.GetValue(Acquisition),
            VisualisationMs = parsed.GetValue(Visualisation),
            VisualisationErrorMs = parsed.GetValue(VisualisationError),
            Load = parsed.GetValue(Load),
            PublishesPlan = parsed.GetValue(Trajectory),
            Seed = parsed.GetValue(Seed),
            IsVirtual = parsed.GetValue(Virtual),
        };
    }

    static void RequireVirtual(ParseResult parsed)
    {
        RecordingOptions.RequireUnset(parsed, DemoMessages.NotWithVirtual, Paper, Load);
        if (parsed.GetValue(Sampling) < MinVirtualSamplingMs)
            throw new InputException(DemoMessages.SamplingWithVirtual(parsed.GetValue(Sampling), MinVirtualSamplingMs));
    }

    static string[] WarningsOf(MotionRecording recording, RecordedMotion motion, double samplingMs) =>
        [.. new[] { RowInterval.WarningOf(recording, samplingMs), motion.Warning }.Where(warning => warning != null)];

    static async Task<int> RunAsync(DemoSettings settings, ParseResult parsed, string folder, CancellationToken cancel)
    {
        using var output = DemoOutput.At(folder, isPaper: false, parsed.GetValue(Robot), parsed.GetValue(Recording), parsed.GetValue(Profile));
        output.RemoveEarlier();
        foreach (var warning in settings.MotionWarnings) await Console.Error.WriteLineAsync(ConsoleMessages.Line(warning));
        var run = await DemoStage.PlayAsync(settings, output.SessionPath, cancel);
        var repeats = parsed.GetValue(Repeats);
        if (repeats == 1 || cancel.IsCancellationRequested) return Finish(run, output, cancel.IsCancellationRequested);
        // The session, the plots and the other results are those of the first repeat, as with --paper.
        var results = new List<DemoResult> { ResultOf(run) };
        while (results.Count < repeats)
        {
            await Console.Error.WriteLineAsync(ConsoleMessages.Repeat(results.Count + 1, repeats));
            var next = await DemoStage.PlayAsync(settings with { Seed = settings.Seed + results.Count }, recordingPath: null, cancel);
            if (cancel.IsCancellationRequested) break;
            results.Add(ResultOf(next));
        }
        var missing = results.Count < repeats ? DemoMessages.FiguresInterrupted(results.Count, repeats) : null;
        return Finish(run, output, isInterrupted: false, DemoRepeats.Of(results), missing);
    }

    static DemoResult ResultOf(DemoRun run) => run.Failure() is string failure ? throw new DemoFailedException(failure) : new DemoScore(run).Result();

    /// <summary>Writes and prints the result of a run.</summary>
    /// <param name="isInterrupted">Whether the user ended the run. Its partial result is then written, even if it is not valid.</param>
    /// <param name="repeats">The figures of all repeats; null without repeats.</param>
    /// <param name="missing">Message that the user ended the repeats; null if they are complete.</param>
    /// <returns>The exit status.</returns>
    /// <exception cref="DemoFailedException">A complete run has no valid result.</exception>
    internal static int Finish(DemoRun run, DemoOutput output, bool isInterrupted, DemoRepeats repeats = null, string missing = null)
    {
        if (!isInterrupted && run.Failure() is string failure) throw new DemoFailedException(failure);
        var score = new DemoScore(run);
        var result = score.Result();
        var interruption = isInterrupted ? DemoMessages.Interrupted(result.Seconds, run.Settings.Seconds) : missing;
        result = result with { Repeats = repeats, Notes = run.Notes(interruption) };
        output.Write(score, run, result);
        DemoTable.Print(run, score, result, output);
        return interruption == null ? ExitStatus.Done : ExitStatus.Interrupted;
    }
}
