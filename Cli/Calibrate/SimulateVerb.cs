using System.CommandLine;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate simulate</c>: creates pictures with known true values, to try the evaluation without hardware.</summary>
static class SimulateVerb
{
    static readonly SimulationSettings Standard = new();

    static readonly Option<int> Pictures = NumberOption.Create("--pictures", "Number of pictures", Standard.Pictures, 1, 100_000, "");
    static readonly Option<double> Visu = NumberOption.Create("--visu-ms", "True L_visu while frames are ready in time", Standard.VisuMs, 17, 300, "ms");
    static readonly Option<double> Spoiled = NumberOption.Create("--spoiled", "Share of pictures with a defect", Standard.Spoiled, 0, 1, "");
    static readonly Option<int> PerPlace = NumberOption.Create(
        "--per-place", "Number of pictures after which the camera changes its position", Standard.PicturesPerPlace, 1, 100_000, "");
    static readonly Option<int> LoadSteps = NumberOption.Create(
        "--load-steps", "Number of load steps from 0 to 2 million vertices; 0 means a constant load of 300 000 vertices", Standard.LoadSteps, 0, 100, "");
    static readonly Option<double> Lit = NumberOption.Create(
        "--lit-ms",
        "Time for which each frame is lit; the results scatter by half of the sum of this time and the exposure", Standard.LitMs, 0.5, 16.6, "ms");
    static readonly Option<double> Exposure = NumberOption.Create(
        "--exposure-ms", "Maximum exposure time; exposures are distributed uniformly from 1 ms to this value", Standard.ExposureMs, 1, 40, "ms");
    static readonly Option<double?> Fps = NumberOption.CreateOptional(
        "--fps",
        "Rate of a video: pictures at fixed intervals with the maximum exposure time, also while the display is dark. Default: random times",
        1.0, 1000, "pictures per second");
    static readonly Option<double> Readout = NumberOption.Create(
        "--readout-ms", "Rolling shutter: delay of the last row's exposure after the first row's", 0.0, -100, 100, "ms");
    static readonly Option<double?> HeadLatency = NumberOption.CreateOptional(
        "--head-latency-ms", "Create pictures for calibrate head instead: headset and camera turn left and right with this latency for head motion, at "
        + "30 pictures per second, from one position and at a constant load", -100.0, 300, "ms");
    static readonly Option<int> Seed = NumberOption.Create("--seed", "Seed of the random numbers", Standard.Seed, int.MinValue, int.MaxValue, "");
    static readonly Option<bool> Check = SwitchOption.Create(
        "--check", "Read each picture immediately instead of storing it, and report the accuracy. The exit status is 1 if the error is too large.");
    static readonly Option<string> Output = TextOption.Create("--out", "Folder for pictures, sweep.csv and truth.csv", standard: "nowpose-pictures");

    public static Command Create()
    {
        var verb = new Command("simulate", "Create pictures of a simulated display and LED matrix, with a sweep's log and the true values, as a test of calibrate vlc.")
        {
            Pictures, PerPlace, Visu, Spoiled, LoadSteps, Lit, Exposure, Fps, Readout, HeadLatency, Seed, Check, Output,
        };
        // Runs on a separate thread, so that Ctrl-C can request a partial result and wait for it.
        verb.SetAction((parsed, cancel) => Task.Run(() => Run(parsed, cancel), CancellationToken.None));
        return verb;
    }

    static int Run(ParseResult parsed, CancellationToken cancel)
    {
        var settings = new SimulationSettings
        {
            Pictures = parsed.GetValue(Pictures), PicturesPerPlace = parsed.GetValue(PerPlace), VisuMs = parsed.GetValue(Visu),
            Spoiled = parsed.GetValue(Spoiled), LoadSteps = parsed.GetValue(LoadSteps),
            LitMs = parsed.GetValue(Lit), ExposureMs = parsed.GetValue(Exposure), PicturesPerSecond = parsed.GetValue(Fps),
            ReadoutMs = parsed.GetValue(Readout), Seed = parsed.GetValue(Seed),
        };
        if (parsed.GetValue(HeadLatency) is double latency)
            settings = settings with { HeadLatencyMs = latency, LoadSteps = 0, PicturesPerPlace = settings.Pictures };
        var status = parsed.GetValue(Check) ? CheckAll(settings, cancel) : TakeAll(settings, parsed.GetValue(Output), cancel);
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : status;
    }

    static int CheckAll(SimulationSettings settings, CancellationToken cancel)
    {
        var check = SimulationCheck.Run(settings, cancel);
        foreach (var line in check.Lines()) Console.Out.WriteLine(line);
        // These limits are documented: one misread picture in 10 000 is allowed.
        var isGood = Math.Abs(check.MeanErrorMs) <= 1 && check.ErrorP95Ms <= 2 && check.Misread <= Math.Max(1, check.Pictures / 10_000);
        return isGood ? ExitStatus.Done : ExitStatus.Failed;
    }

    static int TakeAll(SimulationSettings settings, string folder, CancellationToken cancel)
    {
        var taken = SimulationOutput.Write(settings, folder, cancel);
        var full = Path.GetFullPath(folder);
        Console.Out.WriteLine(SimulationMessages.Written(taken, Path.Combine(full, "pictures"), Path.Combine(full, "sweep.csv"), Path.Combine(full, "truth.csv")));
        return ExitStatus.Done;
    }
}
