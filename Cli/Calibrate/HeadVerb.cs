using System.CommandLine;
using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Profile;

namespace Nowpose.Cli.Calibrate;

/// <c>calibrate head PICTURES</c>: the latency that remains for head motion, from pictures of both codes while the headset moves.
static class HeadVerb
{
    static readonly Argument<string[]> Pictures = new("PICTURES")
    {
        Description = "Pictures of a headset that is turned to the left and right, 25 per second or more, in the order in which they were taken: files, "
            + "a folder or a video (needs ffmpeg).",
        Arity = ArgumentArity.OneOrMore,
    };
    static readonly Option<double> Readout = VlcVerb.ReadoutOption();
    static readonly Option<double> ControlDelay = VlcVerb.ControlDelayOption();
    static readonly Option<string> Earlier = new("--profile")
    {
        Description = "Profile of the still pictures, to which the latency for head motion is added",
    };
    static readonly Option<string> Output = OutOption.Create();
    static readonly Option<bool> Json = OutOption.Json();
    static readonly DeviceOptions Device = new();

    public static Command Create()
    {
        var verb = new Command(
            "head", "Measure the latency that remains for head motion after late-stage reprojection, from pictures of both codes in motion.")
        {
            Pictures, Readout, ControlDelay, Earlier, Output, Json,
        };
        Device.AddTo(verb);
        // On a separate thread, so that Ctrl-C finds the action started and can wait for its partial result.
        verb.SetAction((parsed, cancel) => Task.Run(() => Run(parsed, cancel), CancellationToken.None));
        return verb;
    }

    static int Run(ParseResult parsed, CancellationToken cancel)
    {
        var arguments = parsed.GetValue(Pictures);
        var files = PictureFiles.Of(arguments);
        var earlier = EarlierProfile.Read(parsed.GetValue(Earlier), Device.Conditions(parsed));
        var output = CalibrationOutput.At(parsed.GetValue(Output));
        var read = new VlcRun(new PictureReader(parsed.GetValue(Readout), parsed.GetValue(ControlDelay))).Run(files, isStill: false, cancel);
        VlcVerb.Tell(read);
        if (read.Read.Count == 0)
            return cancel.IsCancellationRequested ? ExitStatus.Interrupted : throw new InputException(read.NothingRead());
        var result = ResultOf(read, arguments[0]);
        var profile = earlier.With(new HeadMotionLatency(result.LatencyMs, result.UncertaintyMs));
        var page = earlier.WithWarnings(HeadPage.Of(result, profile, earlier.Conditions));
        var written = output.Write(profile, page);
        ResultTable.Print(page, written, output.PagePath, parsed.GetValue(Json) ? HeadJson.Of(result) : null);
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
    }

    static HeadResult ResultOf(VlcResult read, string name)
    {
        try
        {
            return new HeadResult(read);
        }
        catch (InputException bad)
        {
            throw new InputException($"{name}: {bad.Message}");
        }
    }
}
