using System.CommandLine;
using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate;

/// <summary>
/// <c>calibrate head PICTURES</c>: measures the latency that remains for head motion, from pictures of both codes, taken through a moving headset.
/// </summary>
static class HeadVerb
{
    static readonly Argument<string[]> Pictures = new("PICTURES")
    {
        Description = "Pictures of a headset that turns left and right, at 25 pictures per second or more, in the order in which they were taken: files, "
            + "a folder or a video (needs ffmpeg).",
        Arity = ArgumentArity.OneOrMore,
    };
    static readonly Option<double> Readout = VlcVerb.ReadoutOption();
    static readonly Option<double> ControlDelay = VlcVerb.ControlDelayOption();
    static readonly Option<string> Earlier = TextOption.Create(
        "--profile", "Profile measured with a still headset; the latency for head motion is added to it");
    static readonly CalibrationOptions Shared = new();

    public static Command Create()
    {
        var verb = new Command(
            "head", "Measure the latency that remains for head motion after late-stage reprojection, from pictures of both codes in motion.")
        {
            Pictures, Readout, ControlDelay, Earlier,
        };
        Shared.AddTo(verb);
        verb.SetAction((parsed, cancel) => RunAsync(
            parsed, files => new VlcRun(new PictureReader(parsed.GetValue(Readout), parsed.GetValue(ControlDelay))).Run(files, cancel), cancel));
        return verb;
    }

    /// <param name="readPictures">Reads the codes in the pictures with these paths.</param>
    internal static async Task<int> RunAsync(ParseResult parsed, Func<IReadOnlyList<string>, VlcResult> readPictures, CancellationToken cancel)
    {
        var arguments = parsed.GetValue(Pictures);
        var files = PictureFiles.Of(arguments);
        var earlier = await Invocation.ReadAsync(() => EarlierProfile.Read(parsed.GetValue(Earlier), Shared.Conditions(parsed)), cancel);
        var output = Shared.Output(parsed);
        var read = readPictures(files);
        VlcVerb.ReportRejected(read);
        if (read.Read.Count == 0)
            return cancel.IsCancellationRequested ? ExitStatus.Interrupted : throw new InputException(read.NothingRead());
        if (ResultOf(read, arguments[0], cancel, earlier.Conditions.DisplayHz) is not { } result) return ExitStatus.Interrupted;
        var profile = earlier.With(new HeadMotionLatency(result.LatencyMs, result.UncertaintyMs));
        var page = earlier.WithWarnings(HeadPage.Of(result, profile, earlier.Conditions));
        Shared.Finish(parsed, output, profile, page, result.Json, cancel.IsCancellationRequested);
        return ExitStatus.Done;
    }

    /// <returns>The result; null if the run was cancelled before enough pictures were read.</returns>
    internal static HeadResult ResultOf(VlcResult read, string name, CancellationToken cancel, double? displayHz = null)
    {
        try
        {
            return InputPlace.In(name, () => new HeadResult(read, displayHz));
        }
        catch (InputException fault) when (cancel.IsCancellationRequested)
        {
            Console.Error.WriteLine(ConsoleMessages.Line(fault.Message));
            return null;
        }
    }
}
