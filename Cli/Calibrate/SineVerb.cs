using System.CommandLine;
using Nowpose.Cli.Calibrate.Sine;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate sine RECORDING</c>: measures the end-to-end latency from a video of a back-and-forth jog.</summary>
static class SineVerb
{
    static readonly Argument<string> Recording = new("RECORDING")
    {
        Description = "Table of positions in the camera's pictures (.csv, .csv.gz): the time in s (t or t_s), then robot and hologram in pixels; "
            + "or a video (needs ffmpeg), with --robot-box and --hologram-box.",
    };
    static readonly Option<string> Columns = TextOption.Create(
        "--columns", "Names of the columns of robot and hologram, if there are more than two: ROBOT,HOLOGRAM");
    static readonly Option<string> Control = TextOption.Create(
        "--control", "Positions recorded by the control system, if the camera uses the control clock; RECORDING then has the hologram only");
    static readonly Option<string> Joint = TextOption.Create("--joint", "Column of --control");
    static readonly Option<PictureBox?> RobotBox = BoxOption.Create("--robot-box", "Video: a patch of the robot's tool in the first picture");
    static readonly Option<PictureBox?> HologramBox = BoxOption.Create("--hologram-box", "Video: a patch of the hologram in the first picture");
    static readonly Option<bool> Inverted = SwitchOption.Create("--inverted", "The values of robot and hologram increase in opposite directions");
    static readonly Option<double?> Application = NumberOption.CreateOptional(
        "--app-ms", "If the recording shows the ghost (compensation off): L_app from the status panel", 0.0, 1000, "ms");
    static readonly Option<double> Sampling = NumberOption.Create(
        "--sampling-ms", "With --app-ms: sampling interval T_s; half of it is subtracted, too", 50.0, 1, 1000, "ms");
    static readonly Option<double?> Configured = NumberOption.CreateOptional(
        "--visu-ms", "If the recording shows the gripper (compensation on): L_visu that the headset used; the measured lag is the error of this "
            + "value", 0.0, 500, "ms");
    static readonly Option<double?> Exposure = NumberOption.CreateOptional(
        "--exposure-ms",
        "Exposure time of the camera; half of it bounds the error of a camera in step with the display. Default: the camera's interval",
        0.0, 1000, "ms");
    static readonly Option<double> Readout = VlcVerb.ReadoutOption();
    static readonly Option<double?> Former = FormerVisuOption.Create(Configured);
    static readonly Option<string> Earlier = EarlierProfile.Option();
    static readonly CalibrationOptions Shared = new();

    public static Command Create()
    {
        var verb = new Command("sine", "Estimate the end-to-end latency from a filmed jog back and forth. A phone's camera is sufficient.")
        {
            Recording, Columns, Control, Joint, RobotBox, HologramBox, Inverted, Application, Sampling, Configured, Exposure, Readout, Former,
            Earlier,
        };
        Shared.AddTo(verb);
        verb.SetAction(RunAsync);
        return verb;
    }

    internal static async Task<int> RunAsync(ParseResult parsed, CancellationToken cancel)
    {
        var path = parsed.GetValue(Recording);
        var way = SineWay.Of(parsed.GetValue(Application), parsed.GetValue(Sampling), parsed.GetValue(Configured) ?? parsed.GetValue(Former));
        var earlier = await Invocation.ReadAsync(() => EarlierProfile.Read(parsed.GetValue(Earlier), Shared.Conditions(parsed)), cancel);
        var isVideo = PictureFiles.IsVideo(path);
        if (!isVideo && parsed.GetValue(Readout) != 0) throw new InputException(SineMessages.ReadoutOfTable);
        SineTracks tracks;
        LagEstimate lag;
        try
        {
            tracks = isVideo
                ? FilmedJog.Track(path, parsed.GetValue(RobotBox), parsed.GetValue(HologramBox), parsed.GetValue(Readout), cancel)
                : await Invocation.ReadAsync(() => Table(parsed, path), cancel);
            if (parsed.GetValue(Inverted)) tracks = tracks with { Shown = [.. tracks.Shown.Select(each => -each)] };
            lag = InputPlace.In(path, () => LagEstimator.Of(tracks));
        }
        catch (InputException fault) when (isVideo && cancel.IsCancellationRequested)
        {
            // The pictures so far are too few.
            await Console.Error.WriteLineAsync(ConsoleMessages.Line(fault.Message));
            return ExitStatus.Interrupted;
        }
        // Long tables take seconds.
        if (!isVideo) cancel.ThrowIfCancellationRequested();
        var result = new SineResult(tracks, lag, way, new SineCamera(parsed.GetValue(Exposure), earlier.Conditions.DisplayHz));
        if (result.VisuMs is < 0 or > LatencyProfile.MaxVisuMs)
            throw new InputException($"{path}: {SineMessages.VisuOutOfRange(result.VisuMs.Value, result.TotalMs, LatencyProfile.MaxVisuMs)}");
        var output = Shared.Output(parsed);
        var profile = result.VisuMs is double visuMs ? earlier.With(visuMs, result.DeviationMs, CalibrationMethod.Sine, measurements: 1) : null;
        var page = earlier.WithWarnings(SinePage.Of(result, profile, path));
        Shared.Finish(parsed, output, profile, page, result.Json, cancel.IsCancellationRequested);
        return ExitStatus.Done;
    }

    static SineTracks Table(ParseResult parsed, string path) => parsed.GetValue(Control) is string control
        ? SineTracks.Of(path, parsed.GetValue(Columns), control, parsed.GetValue(Joint))
        : SineTracks.Of(path, parsed.GetValue(Columns));
}
