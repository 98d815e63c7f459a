using System.Globalization;
using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Options;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

public class FilmedJogTests : VideoFolder
{
    const int Width = 320, Height = 160, Frames = 200, Patch = 32;
    const double Fps = 60, LagMs = 96, Reach = 50;

    // The tool moves along an oblique line. Positions are in pixels and can be fractions.
    static (double X, double Y) RobotAt(double time) => (160 + Reach * Swing(time), 36 + 10 * Swing(time));

    static (double X, double Y) HologramAt(double time) => (160 + Reach * Swing(time - LagMs / 1000), 112 + 10 * Swing(time - LagMs / 1000));

    static double Swing(double time) => Math.Sin(2 * Math.PI * time / 2.2 + 0.4);

    static string Box((double X, double Y) middle) =>
        string.Create(CultureInfo.InvariantCulture, $"{Math.Round(middle.X) - Patch / 2},{Math.Round(middle.Y) - Patch / 2},{Patch},{Patch}");

    double[] _times;
    byte[][] _pictures;

    // All tests use the same pictures, because drawing them takes longer than reading them.
    [OneTimeSetUp]
    public void Draw()
    {
        _times = [.. Enumerable.Range(0, Frames).Select(i => i / Fps + (i % 7 == 0 ? 0.002 : 0))];
        var random = new Random(5);
        _pictures = [.. _times.Select(time => Drawn(RobotAt(time), HologramAt(time), random))];
    }

    string Video() => Video("jog.mp4", Width, Height, _pictures, _times);

    static byte[] Drawn((double X, double Y) robot, (double X, double Y) hologram, Random random)
    {
        var picture = new byte[Width * Height];
        for (var i = 0; i < picture.Length; i++)
        {
            double x = i % Width, y = i / Width;
            var light = 90 + 20 * Math.Sin(x / 40) + Spot(x - robot.X, y - robot.Y, 1) + Spot(x - hologram.X, y - hologram.Y, -1);
            picture[i] = (byte)Math.Clamp(light + 4 * (random.NextDouble() - 0.5), 0, 255);
        }
        return picture;
    }

    // Draws a smooth spot, which can be at fractions of a pixel. Robot and hologram have different patterns.
    static double Spot(double x, double y, int sign) =>
        sign * 90 * Math.Exp(-(x * x + y * y) / 120) * Math.Cos(x / 4 + sign * y / 5);

    [Test]
    public async Task Sine_Video_TracksBothPatchesAndMeasuresTheLag()
    {
        var video = Video();

        var run = await CliRun.OfAsync(
            "calibrate", "sine", video, "--robot-box", Box(RobotAt(0.002)), "--hologram-box", Box(HologramAt(0.002)), "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("total_ms").GetDouble(), Is.EqualTo(LagMs).Within(3));
    }

    // A camera that needs 20 ms for its rows exposes the lower patch later, when the hologram has moved on.
    [Test]
    public async Task Sine_ReadOutTime_CorrectsTheHeightsOfThePatches()
    {
        var video = Video();

        var run = await CliRun.OfAsync(
            "calibrate", "sine", video, "--robot-box", Box(RobotAt(0.002)), "--hologram-box", Box(HologramAt(0.002)),
            "--readout-ms", "20", "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        const double LaterMs = 20.0 * (112 - 36) / Height;
        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("total_ms").GetDouble(), Is.EqualTo(LagMs + LaterMs).Within(3));
    }

    [Test]
    public async Task Sine_FfmpegOlderThanVersion5Point1_UsesTheOldOption()
    {
        var video = Video();
        Script(
            "ffmpeg",
            "case \"$*\" in *-fps_mode*) echo \"Unrecognized option 'fps_mode'.\" >&2; exit 1;; "
            + $"*) cat '{FramesPath}';; esac");

        var run = await CliRun.OfAsync(
            "calibrate", "sine", video, "--robot-box", Box(RobotAt(0.002)), "--hologram-box", Box(HologramAt(0.002)), "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
    }

    // The stand-in of ffmpeg waits after its first pictures until the command has been interrupted.
    [TestCase(150, true)]
    [TestCase(20, false)]
    public async Task Sine_VideoInterrupted_EvaluatesThePicturesSoFar(int pictures, bool areEnough)
    {
        var video = Video();
        var (half, go) = (Path.Combine(Folder, "half"), Path.Combine(Folder, "go"));
        var bytes = 3 * Width * Height * pictures;
        Script("ffmpeg", $"head -c {bytes} '{FramesPath}'; : > '{half}'; until [ -e '{go}' ]; do sleep 0.02; done; tail -c +{bytes + 1} '{FramesPath}'");
        string[] args =
        [
            "calibrate", "sine", video, "--robot-box", Box(RobotAt(0.002)), "--hologram-box", Box(HologramAt(0.002)), "--visu-ms", "0", "--out", Out,
        ];
        using var ctrlC = new CancellationTokenSource();
        var running = Task.Run(() => CapturedConsole.OfAsync(
            () => Invocation.RunAsync(Invocation.Root("nowpose", "", CalibrateVerb.Create()), args, cancel: ctrlC.Token)));
        await Soon.BecomesAsync(() => File.Exists(half), () => "the first pictures are read");

        await ctrlC.CancelAsync();
        await File.WriteAllTextAsync(go, "");

        var run = await running.Bounded();
        Assert.That(run.Status, Is.EqualTo(130), run.Errors);
        Assert.That(File.Exists(Path.Combine(Out, "profile.json")), Is.EqualTo(areEnough), run.Errors);
        Assert.That(run.Errors, Does.Contain(areEnough ? CalibrationMessages.Interrupted : "at least 60"));
    }

    [Test]
    public async Task Sine_InvalidBoxes_NamesTheBoxes()
    {
        var video = Video();

        Assert.That(await RefusalOf("sine", video), Is.EqualTo(ConsoleMessages.Line(SineMessages.NoBox("--robot-box"))));
        Assert.That(await RefusalOf("sine", video, "--robot-box", "300,20,32,32", "--hologram-box", "10,10,32,32"),
            Is.EqualTo(ConsoleMessages.Line(SineMessages.BoxOutside("--robot-box", 300, 20, 32, 32, 320, 160))));
        Assert.That(
            await RefusalOf("sine", video, "--robot-box", "1,2,3", "--hologram-box", "10,10,32,32"),
            Does.Contain(OptionValueMessages.NotABox("--robot-box", "1,2,3", 8, 10_000)));
    }

    [Test]
    public async Task Sine_PatchDisappears_NamesThePictureAndThePatch()
    {
        var video = Video();
        using (var raw = File.OpenWrite(FramesPath))
        {
            // All pictures from the hundredth one on contain only noise.
            const int Bytes = 3 * Width * Height;
            raw.Position = 100L * Bytes;
            var noise = new byte[Bytes];
            new Random(1).NextBytes(noise);
            raw.Write(noise);
        }

        var refusal = await RefusalOf("sine", video, "--robot-box", Box(RobotAt(0.002)), "--hologram-box", Box(HologramAt(0.002)));
        var numbers = MessageNumbers.In(refusal, SineMessages.PatchLost("", 0, isRobot: true, 0, 0));
        Assert.That(numbers[0], Is.EqualTo(101));
        Assert.That(numbers[1], Is.LessThan(numbers[2]), "the match is below the required one");
    }
}
