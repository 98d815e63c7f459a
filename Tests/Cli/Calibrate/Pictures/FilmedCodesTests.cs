using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>Tests a filmed load sweep. The video shows every fourth frame, with both codes side by side in front of a dark wall.</summary>
public class FilmedCodesTests : VideoFolder
{
    const int Width = 480, Height = 240, Cell = 16, FramesPerLoad = 48, FramesPerPicture = 4;
    const double TrueMs = 40, TrueLimitMs = 1000 / 60.0 - 1.5;

    static readonly int[] Loads = [0, 400_000, 800_000, 1_200_000, 1_600_000, 2_000_000];

    string _video, _sweep;
    List<double> _truth;
    List<byte[]> _pictures;

    [SetUp]
    public void Film()
    {
        var pipeline = new DisplayPipeline(4, new DisplayPipelineSettings(plateauMs: TrueMs));
        _pictures = [];
        _truth = [];
        _sweep = Path.Combine(Folder, "sweep.csv");
        using (var log = File.CreateText(_sweep))
        {
            SweepLog.WriteHeader(log);
            for (var i = 0; i < Loads.Length * FramesPerLoad; i++)
            {
                var vertices = Loads[i / FramesPerLoad];
                var frame = pipeline.Next(vertices);
                var start = ControlTime.FromSeconds(1000) + frame.Start;
                SweepLog.Write(log, new SweepRow(
                    start, vertices, frame.RenderTime.TotalMilliseconds, RenderTimeSourceKind.EngineGpuTime, "HoloLens 2", 60));
                if (i % FramesPerPicture != 0) continue;
                _truth.Add(frame.Visualisation.TotalMilliseconds);
                _pictures.Add(Drawn(TimestampCode.ValueOf(start + frame.Visualisation), TimestampCode.ValueOf(start)));
            }
        }
        _video = Filmed([.. _pictures.Take(12)], [1, 1, 1]);
    }

    string Filmed(IReadOnlyList<byte[]> pictures, double[] colour) =>
        Video("sweep.mp4", Width, Height, pictures, pictures.Select((_, i) => i / 15.0), colour);

    static byte[] Drawn(int control, int headset)
    {
        var picture = new byte[Width * Height];
        Array.Fill(picture, (byte)40);
        Draw(picture, control, CodeKind.Control, left: 50);
        Draw(picture, headset, CodeKind.Headset, left: 300);
        return picture;
    }

    static void Draw(byte[] picture, int value, CodeKind kind, int left)
    {
        const int Top = 56;
        // The squares on the display touch each other. The LEDs have gaps between them.
        var gap = kind == CodeKind.Control ? 1 : 0;
        Span<bool> lit = stackalloc bool[TimestampCode.CellCount];
        TimestampCode.Draw(value, kind, lit);
        for (var cell = 0; cell < lit.Length; cell++)
        {
            int x = left + cell % TimestampCode.Side * Cell + gap, y = Top + cell / TimestampCode.Side * Cell + gap;
            for (var row = y; lit[cell] && row < y + Cell - 2 * gap; row++) picture.AsSpan(row * Width + x, Cell - 2 * gap).Fill(210);
        }
    }

    [Test]
    public async Task Vlc_VideoAndSweepLog_FindsTheLimit()
    {
        Filmed(_pictures, [1, 1, 1]);

        var run = await CliRun.OfAsync("calibrate", "vlc", _video, "--sweep", _sweep, "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        var pictures = json.RootElement.GetProperty("per_picture").EnumerateArray().ToList();
        var names = pictures.Select(picture => picture.GetProperty("file").GetString());
        Assert.That(names, Is.EqualTo(Enumerable.Range(1, _truth.Count).Select(i => $"{_video}#{i}")));
        Assert.That(json.RootElement.GetProperty("decoded").GetInt32(), Is.EqualTo(_truth.Count), run.Errors);
        foreach (var (picture, visuMs) in pictures.Zip(_truth))
            Assert.That(picture.GetProperty("visu_ms").GetDouble(), Is.EqualTo(visuMs).Within(1.01), picture.GetProperty("file").GetString());
        Assert.That(File.ReadLines(Path.Combine(Out, "pairs.csv")).Count(), Is.EqualTo(1 + _truth.Count));
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(1));
        // The steps between the loads are large, so the limit can be anywhere between the loads below and above it. The render times also scatter.
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.InRange(14.1, 1.02 * TrueLimitMs));
        Assert.That((profile.Device, profile.Range.Source), Is.EqualTo(("HoloLens 2", RenderTimeSourceKind.EngineGpuTime)));
    }

    [TestCase(1, 0, 0)]
    [TestCase(0, 1, 0)]
    [TestCase(0, 0, 1)]
    public async Task Vlc_VideoOfColouredLight_ReadsTheBrightestColourChannel(double red, double green, double blue)
    {
        const int Count = 4;
        var video = Filmed([.. _pictures.Take(Count)], [red, green, blue]);

        var run = await CliRun.OfAsync("calibrate", "vlc", video, "--json", "--out", Out);

        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("decoded").GetInt32(), Is.EqualTo(Count), run.Errors);
    }

    [Test]
    public async Task Vlc_VideoUnreadableByFfmpeg_StatesTheReason()
    {
        Script("ffmpeg", "echo 'moov atom not found' >&2; exit 1");

        Assert.That(await RefusalOf("vlc", _video),
            Is.EqualTo(ConsoleMessages.Line(PictureMessages.NoFramesByFfmpeg(_video, "moov atom not found"))));
    }

    [Test]
    public async Task Vlc_TruncatedVideo_ReadsCompletePicturesAndWarns()
    {
        const int Whole = 10;
        Script("ffmpeg", $"head -c {Whole * 3 * Width * Height + 1000} '{FramesPath}'; echo 'partial file' >&2; exit 1");

        var run = await CliRun.OfAsync("calibrate", "vlc", _video, "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("pictures").GetInt32(), Is.EqualTo(Whole));
        Assert.That(run.Errors, Does.Contain(ConsoleMessages.FfmpegReports(_video, Whole, "partial file")));
    }

    [Test]
    public async Task Vlc_VideoTogetherWithPictures_Fails() =>
        Assert.That(await RefusalOf("vlc", _video, Write("a.jpg", [])), Is.EqualTo(ConsoleMessages.Line(PictureMessages.VideoNotAlone(_video))));
}
