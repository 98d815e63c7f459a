using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Robots;
using Nowpose.Prediction;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary><c>demo</c>, the main job: gateway, network, headset runtime and a moving robot in one process, scored against the truth.</summary>
static class DemoVerb
{
    static readonly Option<double> Seconds = NumberOption.Create("--seconds", "How long to run", 20.0, 5, 3600, "s");
    static readonly Option<string> Network = ChoiceOption.Create("--network", "Simulated network between gateway and headset", "wifi", [.. NetworkProfile.All.Select(p => p.Name)]);
    static readonly Option<string> Robot = new("--robot") { Description = "youbot, ur5 or a .urdf file", DefaultValueFactory = _ => "youbot" };
    static readonly Option<string> Recording = new("--recording") { Description = "Motion to play forth and back: .csv or .csv.gz, time in s, then one column per joint" };
    static readonly Option<string> Predictor = ChoiceOption.Create("--predictor", "How joints are predicted", Predictors.Default, [.. Predictors.Names]);
    static readonly Option<double> Sampling = NumberOption.Create("--sampling-ms", "Sampling interval T_s of the control system", 50.0, 1, 1000, "ms");
    static readonly Option<MillisecondRange> Acquisition = RangeOption.Create("--acquisition-ms", "What subscription and middleware add to each sample before it is sent", new MillisecondRange(55, 105), 1000);
    static readonly Option<double> Visualisation = NumberOption.Create("--visu-ms", "True display latency of the simulated headset", 40.0, 0, 400, "ms");
    static readonly Option<double> VisualisationError = NumberOption.Create("--visu-error-ms", "Error of the display latency that the runtime is told", 0.0, -100, 100, "ms");
    static readonly Option<int> Seed = NumberOption.Create("--seed", "Seed of everything random", 1, 0, 1_000_000, "");
    static readonly Option<string> Output = new("--out") { Description = "Folder for report.html and result.json", DefaultValueFactory = _ => "nowpose-demo" };

    public static Command Create()
    {
        var verb = new Command("demo", "Run the headset runtime against a simulated cell over real sockets, and score what it shows against the truth.")
        {
            Seconds, Network, Robot, Recording, Predictor, Sampling, Acquisition, Visualisation, VisualisationError, Seed, Output,
        };
        verb.SetAction((parsed, cancel) => RunAsync(Settings(parsed), cancel));
        return verb;
    }

    static DemoSettings Settings(ParseResult parsed)
    {
        var robot = parsed.GetValue(Robot);
        var told = parsed.GetValue(Visualisation) + parsed.GetValue(VisualisationError);
        if (told is < 0 or > 500)
            throw new InputException(FormattableString.Invariant($"--visu-ms plus --visu-error-ms: {told} ms is out of range; allowed are 0 to 500 ms"));
        return new DemoSettings(
            parsed.GetValue(Seconds), NetworkProfile.Named(parsed.GetValue(Network)), RobotFiles.Load(robot), RobotFiles.LoadText(robot),
            parsed.GetValue(Recording), parsed.GetValue(Predictor), parsed.GetValue(Sampling), parsed.GetValue(Acquisition),
            parsed.GetValue(Visualisation), parsed.GetValue(VisualisationError), parsed.GetValue(Seed), parsed.GetValue(Output));
    }

    static async Task<int> RunAsync(DemoSettings settings, CancellationToken cancel)
    {
        var output = DemoOutput.At(settings.OutputFolder);
        var run = await DemoRun.PlayAsync(settings, cancel);
        var score = new DemoScore(run);
        var result = score.Result();
        output.Write(score, run, result);
        DemoTable.Print(settings, score, result, output);
        if (cancel.IsCancellationRequested) return ExitStatus.Interrupted;
        if (score.Errors.Count > 0) return ExitStatus.Done;
        Console.Error.WriteLine($"nowpose: nothing could be scored: clock sync {run.Statistics.SyncLink}; joint positions {run.Statistics.SampleLink}");
        return ExitStatus.Failed;
    }
}
