using System.CommandLine;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <c>demo</c>, the default verb: gateway, network, headset runtime and a moving robot in one process, compared with the truth.
static class DemoVerb
{
    static readonly Option<double> Seconds = NumberOption.Create("--seconds", "How long to run", 20.0, 5, 3600, "s");
    static readonly Option<string> Network = ChoiceOption.Create(
        "--network", "Simulated network between gateway and headset", "wifi", [.. NetworkProfile.All.Select(profile => profile.Name)]);
    static readonly Option<string> Robot = new("--robot")
    {
        Description = RobotFiles.Names + " or a .urdf file",
        DefaultValueFactory = _ => "youbot",
    };
    static readonly Option<string> Recording = new("--recording")
    {
        Description = "Motion to play forward and backward: .csv or .csv.gz, time in s, then one column per joint",
    };
    static readonly Option<string> Predictor = PredictorOption.Create();
    static readonly Option<string> Estimator = RuntimeOptions.Estimator();
    static readonly Option<string> Profile = RuntimeOptions.Profile();
    static readonly Option<double> Sampling = NumberOption.Create(
        "--sampling-ms", "Sampling interval T_s of the control system", 50.0, 1, 1000, "ms");
    static readonly Option<MillisecondRange> Acquisition = RangeOption.Create(
        "--acquisition-ms", "What subscription and middleware add to each sample before it is sent", new MillisecondRange(55, 105), 1000);
    static readonly Option<double> Visualisation = NumberOption.Create(
        "--visu-ms", "True display latency of the simulated headset", 40.0, 0, 400, "ms");
    static readonly Option<double> VisualisationError = NumberOption.Create(
        "--visu-error-ms", "Error of the display latency that the runtime uses", 0.0, -100, 100, "ms");
    static readonly Option<int?> Load = NumberOption.CreateOptional(
        "--load", "Vertices to be rendered from the first third of the run to its last quarter", 0, SweepPlan.MaxVertices, "vertices");
    static readonly Option<bool> Trajectory = new("--trajectory")
    {
        Description = "Let the cell publish its set-points ahead of time, too",
    };
    static readonly Option<int> Seed = NumberOption.Create("--seed", "Seed of everything random", 1, 0, 1_000_000, "");
    static readonly Option<string> Output = new("--out")
    {
        Description = "Folder for report.html, result.json and session.jsonl",
        DefaultValueFactory = _ => "nowpose-demo",
    };

    // Light is seen at the next refresh at the earliest.
    const double MinWithLoadMs = 17;

    public static Command Create()
    {
        var verb = new Command(
            "demo", "Run the headset runtime against a simulated cell over real sockets, and score what it shows against the truth.")
        {
            Seconds, Network, Robot, Recording, Predictor, Estimator, Profile, Sampling, Acquisition, Visualisation,
            VisualisationError, Load, Trajectory, Seed, Output,
        };
        verb.SetAction((parsed, cancel) => RunAsync(Settings(parsed), parsed.GetValue(Output), cancel));
        return verb;
    }

    static DemoSettings Settings(ParseResult parsed)
    {
        var told = parsed.GetValue(Visualisation) + parsed.GetValue(VisualisationError);
        if (told is < 0 or > 500)
            throw new InputException(FormattableString.Invariant(
                $"--visu-ms plus --visu-error-ms: {told} ms is out of range; allowed are 0 to 500 ms"));
        if (parsed.GetValue(Load) != null && parsed.GetValue(Visualisation) < MinWithLoadMs)
            throw new InputException(FormattableString.Invariant($"--visu-ms: {parsed.GetValue(Visualisation)} ms is out of range; ")
                + $"with --load allowed are {MinWithLoadMs} to 400 ms, for the display has 60 Hz");
        var robot = RobotFiles.Load(parsed.GetValue(Robot), out var urdf);
        var recording = parsed.GetValue(Recording);
        return new DemoSettings
        {
            Seconds = parsed.GetValue(Seconds),
            Network = NetworkProfile.Named(parsed.GetValue(Network)),
            Robot = robot,
            RobotText = urdf,
            Motion = recording == null ? new PickAndPlaceMotion(robot) : new RecordedMotion(MotionRecording.Read(recording), robot),
            MotionName = recording == null
                ? "pick-and-place cycle of 7-phase moves" : $"recording {Path.GetFileName(recording)}, forward and backward",
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
        };
    }

    static async Task<int> RunAsync(DemoSettings settings, string folder, CancellationToken cancel)
    {
        var output = DemoOutput.At(folder);
        var run = await DemoStage.PlayAsync(settings, output.SessionPath, cancel);
        // An interrupted run writes its partial result. A complete run without a measurement has failed.
        if (!cancel.IsCancellationRequested && run.Failure() is string failure) throw new DemoFailedException(failure);
        var score = new DemoScore(run);
        var result = score.Result();
        output.Write(score, run, result);
        DemoTable.Print(run, score, result, output);
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
    }
}
