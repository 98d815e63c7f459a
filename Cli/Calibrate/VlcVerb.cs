using System.CommandLine;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Gateway.Options;
using Nowpose.Latency.Conditions;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate vlc PICTURES</c>: measures L_visu from pictures that show both the control code and the headset's code.</summary>
static class VlcVerb
{
    /// <summary>Maximum number of rejected pictures that are listed individually.</summary>
    const int MaxListed = 10;

    static readonly Argument<string[]> Pictures = new("PICTURES")
    {
        Description = "Pictures (.png, .jpg) in the order in which they were taken, a folder of them, or a video (needs ffmpeg).",
        Arity = ArgumentArity.OneOrMore,
    };
    static readonly Option<string> Sweep = TextOption.Create("--sweep", "Log of the load sweep, which contains the render time of each picture");
    static readonly Option<double> Readout = ReadoutOption();
    static readonly Option<double> ControlDelay = ControlDelayOption();
    static readonly Option<string> Earlier = EarlierProfile.Option();
    static readonly CalibrationOptions Shared = new();

    public static Command Create()
    {
        var verb = new Command(
            "vlc", "Determine L_visu from pictures of the control code and the headset's code and, with a sweep's log, the constant-latency range.")
        {
            Pictures, Sweep, Readout, ControlDelay, Earlier,
        };
        Shared.AddTo(verb);
        verb.SetAction(RunAsync);
        return verb;
    }

    static async Task<int> RunAsync(ParseResult parsed, CancellationToken cancel)
    {
        var files = PictureFiles.Of(parsed.GetValue(Pictures));
        var (sweep, earlier) = await Invocation.ReadAsync(
            () =>
            {
                DisplayConditions conditions = null;
                var table = parsed.GetValue(Sweep) is string path ? SweepTable.Read(path, out conditions) : null;
                return (table, EarlierProfile.Read(parsed.GetValue(Earlier), Shared.Conditions(parsed), conditions));
            },
            cancel);
        var output = Shared.Output(parsed, hasPairs: true);
        var run = new VlcRun(new PictureReader(parsed.GetValue(Readout), parsed.GetValue(ControlDelay)));
        var result = run.Run(files, cancel);
        ReportRejected(result);
        var status = cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
        if (result.Pictures.Count == 0) return status;
        var evaluation = new VlcEvaluation(result, sweep, earlier);
        var isInterrupted = status == ExitStatus.Interrupted;
        Shared.Finish(parsed, output, evaluation.Profile, evaluation.Page, () => VlcJson.Of(result, evaluation.Profile), isInterrupted);
        if (sweep != null && result.Read.Count > 0)
            output.WritePairs(evaluation.Pictures, new PairOrigin(evaluation.Source, earlier.Conditions), isInterrupted);
        return status != ExitStatus.Done || evaluation.Profile != null ? status : result.Read.Count > 0 ? ExitStatus.Failed : ExitStatus.BadInput;
    }

    public static Option<double> ReadoutOption() => NumberOption.Create(
        "--readout-ms", "Rolling shutter: delay of the last row's exposure after the first row's", 0.0, -100, 100, "ms");

    public static Option<double> ControlDelayOption() => NumberOption.Create(
        "--control-delay-ms",
        "Delay of the device that shows the control code: switching time of LEDs, latency of a monitor. "
        + "Negative if the code is ahead, for example because the PLC program adds a cycle too many.", 0.0, -20, 500, "ms");

    /// <summary>Prints the rejected pictures with their reasons to stderr.</summary>
    public static void ReportRejected(VlcResult result)
    {
        if (result.Read.Count == 0) return;
        var rejected = result.Pictures.Where(picture => !picture.IsRead).ToList();
        foreach (var picture in rejected.Take(MaxListed)) Console.Error.WriteLine(ConsoleMessages.Picture(picture.File, picture.Fault));
        if (rejected.Count > MaxListed) Console.Error.WriteLine(ConsoleMessages.MoreRejected(rejected.Count - MaxListed));
    }
}
