using System.Text.Json;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>
/// Tests calibrations with invalid input. Each of them must print one line with the reason and leave the existing profile unchanged.
/// </summary>
public sealed class BadInputTests : CalibrationFolder
{
    const int Width = 640, Height = 360, Side = 128;
    static readonly string[] Nudge = ["nudge", "--speed-mm-s", "250", "--forward-mm", "2", "--backward-mm", "-2"];

    byte[] _good;

    [SetUp]
    public void CalibrateWell()
    {
        LatencyProfileFile.Save(ProfilePath, Profile("HoloLens 2"));
        _good = File.ReadAllBytes(ProfilePath);
    }

    static LatencyProfile Profile(string device) => new(
        40, 1, device, 60, new DateTime(2026, 11, 20, 13, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300, 15,
        RenderTimeSourceKind.DisplayGpuTime);

    async Task RefusedWith(string message, params string[] arguments)
    {
        Assert.That(await RefusalOf(arguments), Does.Contain(message));
        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(_good));
    }

    // The results of rejected pictures are printed to stdout, as are those of valid pictures.
    async Task RejectedWith(string message, params string[] arguments)
    {
        var run = await CliRun.OfAsync(["calibrate", .. arguments, "--out", Out]);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Complaints[0], Does.Contain(message));
        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(_good));
    }

    /// <summary>Renders a picture of both codes side by side with an L_visu of 40 ms. <paramref name="change"/> modifies the shot.</summary>
    string Picture(string name, Func<Shot, Shot> change = null, double scale = 1)
    {
        Needs.Vision();
        var shot = new Shot(
            (int)(scale * Width), (int)(scale * Height), Scene: 1, SceneLight: 0.1,
            [Code(CodeKind.Control, 30_040, 0.25 * scale, scale, panel: 0.02), Code(CodeKind.Headset, 30_000, 0.75 * scale, scale, panel: null)],
            Blur: 0.6, [0, 0], [], [], Noise: 1, NoiseSeed: 1);
        var path = Path.Combine(Folder, name);
        using var renderer = new VisionPool(1);
        renderer.Look([PictureRequest.Made(change?.Invoke(shot) ?? shot, path)], (_, made) => Assert.That(made.Fault, Is.Null), CancellationToken.None);
        return path;
    }

    static DrawnCode Code(CodeKind kind, int value, double x, double scale, double? panel)
    {
        var lit = new bool[TimestampCode.CellCount];
        TimestampCode.Draw(value, kind, lit);
        double left = x * Width - scale * Side / 2, top = scale * (Height - Side) / 2, size = scale * Side;
        return new DrawnCode(
            [[left, top], [left + size, top], [left + size, top + size], [left, top + size]], [.. lit.Select(each => each ? 1.0 : 0)], 0.6, 0, panel);
    }

    // Also removes the scene, because the reader may at first mistake its edges for a code.
    static Shot WithoutCodes(Shot shot) => shot with { Codes = [], SceneLight = 0 };

    // Half of one code is outside the left edge of the picture. The other code is complete.
    static Shot Halved(Shot shot, CodeKind kind)
    {
        var (half, whole) = kind == CodeKind.Control ? (shot.Codes[0], shot.Codes[1]) : (shot.Codes[1], shot.Codes[0]);
        var middle = half.Corners.Average(corner => corner[0]);
        return shot with { Codes = [whole, half with { Corners = [.. half.Corners.Select(corner => new[] { corner[0] - middle, corner[1] })] }] };
    }

    // Reference for the other tests: without their changes, the pictures are accepted.
    [Test]
    public async Task Vlc_ValidPictures_WritesAProfile()
    {
        var run = await CliRun.OfAsync("calibrate", "vlc", Picture("a.png"), Picture("b.png"), "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(LatencyProfileFile.Load(ProfilePath).Visualisation.Length.TotalMilliseconds, Is.EqualTo(40).Within(1));
    }

    // A PLC program that adds a cycle too many shows a code that is ahead.
    [TestCase("-0.9", true)]
    [TestCase("-21", false)]
    public void Vlc_NegativeControlDelay_IsAcceptedDownToTwentyMilliseconds(string delayMs, bool isValid)
    {
        foreach (var verb in new[] { VlcVerb.Create(), HeadVerb.Create() })
            Assert.That(verb.Parse(["a.png", "--control-delay-ms", delayMs]).Errors, isValid ? Is.Empty : Is.Not.Empty);
    }

    [Test]
    public async Task Vlc_PictureWithoutCode_ReportsThatNoCodeWasFound() =>
        await RejectedWith("wall.png: " + PictureFaults.NoCode, "vlc", Picture("wall.png", WithoutCodes));

    [Test]
    public async Task Vlc_AllPicturesWithoutCode_ReportsTheirCount() => await RejectedWith(
        VlcMessages.NothingRead(2, 2, PictureFaults.NoCode), "vlc", Picture("a.png", WithoutCodes), Picture("b.png", WithoutCodes));

    static readonly object[][] TwoCodes =
        [[CodeKind.Control, PictureFaults.ControlCodes("two")], [CodeKind.Headset, PictureFaults.HeadsetCodes("two")]];

    [TestCaseSource(nameof(TwoCodes))]
    public async Task Vlc_TwoCodesOfTheSameKind_RejectsThePicture(object kind, string fault) =>
        await RejectedWith("two.png: " + fault, "vlc", Picture("two.png", shot => Doubled(shot, (CodeKind)kind)));

    [Test]
    public async Task Vlc_MirroredPicture_ReportsMirroring() =>
        await RejectedWith("mirror.png: " + PictureFaults.Mirrored, "vlc", Picture("mirror.png", Mirrored));

    [Test]
    public async Task Vlc_TwoUnusablePictures_ListsBothWithTheirReasons()
    {
        var folder = Directory.CreateDirectory(Path.Combine(Folder, "mixed")).FullName;
        Picture("mixed/a.png");
        Picture("mixed/b.png");
        Picture("mixed/two.png", shot => Doubled(shot, CodeKind.Control));
        await File.WriteAllTextAsync(Path.Combine(folder, "z.HEIC"), "0000ftypheic");

        var run = await CliRun.OfAsync("calibrate", "vlc", folder, "--out", Out, "--json");

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        var rejected = json.RootElement.GetProperty("rejected_pictures").EnumerateArray()
            .ToDictionary(each => Path.GetFileName(each.GetProperty("file").GetString()), each => each.GetProperty("reason").GetString());
        Assert.That(rejected.Keys, Is.EquivalentTo(new[] { "two.png", "z.HEIC" }));
        Assert.That(rejected["two.png"], Is.EqualTo(PictureFaults.ControlCodes("two")));
        Assert.That(rejected["z.HEIC"], Does.Contain("HEIC").And.Contain("set the camera to JPEG"));
        Assert.That(await File.ReadAllTextAsync(Path.Combine(Out, "calibration.html")), Does.Contain("two.png").And.Contain("z.HEIC"));
    }

    // Reads the pictures in both orders, each with a new worker, so that every picture has other predecessors, and one of each order has none. Then reads
    // them with two workers. The result for a picture must not depend on the other pictures.
    [Test]
    public void Read_PicturesInAnotherOrder_GivesTheSameCodes()
    {
        string[] files =
        [
            Picture("a.png"), Picture("b.png", shot => shot with { Blur = 2.6, Noise = 12 }), Picture("c.png", shot => Halved(shot, CodeKind.Control)),
            Picture("d.png", Moved),
        ];
        var script = Path.Combine(AppContext.BaseDirectory, "vision", "worker.mjs");

        // If the path of the script is given, new workers are started, so none of them has read another picture before.
        using var first = new VisionPool(1, script);
        var codes = CodesOf(files, first);
        Assert.That(codes, Is.Unique.And.All.Not.EqualTo("[]"));
        using var second = new VisionPool(1, script);
        Assert.That(CodesOf(files.Reverse(), second), Is.EqualTo(codes.Reverse()));

        using var two = new VisionPool(2, null, picturesPerWorker: 1);
        var many = CodesOf(UntilBothWork(files, two), two);
        Assert.That(many, Is.EqualTo(many.Select((_, i) => codes[i % codes.Length])));
        Assert.That(two.WorkerCount, Is.EqualTo(2));
    }

    // Returns all files once, and more until the second worker has started. It starts with its first picture.
    static IEnumerable<string> UntilBothWork(string[] files, VisionPool pool)
    {
        for (var i = 0; i < files.Length || pool.WorkerCount < 2; i++) yield return files[i % files.Length];
    }

    static string[] CodesOf(IEnumerable<string> files, VisionPool pool)
    {
        var codes = new SortedDictionary<int, string>();
        pool.Look(files.Select(PictureRequest.File), (place, seen) => codes[place] = JsonSerializer.Serialize(seen.Codes), CancellationToken.None);
        return [.. codes.Values];
    }

    static Shot Moved(Shot shot) =>
        shot with { Codes = [.. shot.Codes.Select(code => code with { Corners = [.. code.Corners.Select(corner => new[] { corner[0] + 9, corner[1] - 6 })] })] };

    // Adds a smaller copy of a code between the two codes.
    static Shot Doubled(Shot shot, CodeKind kind)
    {
        var code = shot.Codes[kind == CodeKind.Control ? 0 : 1];
        var middle = code.Corners.Average(corner => corner[0]);
        double[][] between = [.. code.Corners.Select(corner => new[] { Width / 2 + 0.7 * (corner[0] - middle), 20 + 0.7 * corner[1] })];
        return shot with { Codes = [.. shot.Codes, code with { Corners = between }] };
    }

    static Shot Mirrored(Shot shot) =>
        shot with { Codes = [.. shot.Codes.Select(code => code with { Corners = [code.Corners[1], code.Corners[0], code.Corners[3], code.Corners[2]] })] };

    [TestCase(CodeKind.Control, "half.png: " + PictureFaults.ControlCodeCutOff)]
    [TestCase(CodeKind.Headset, "half.png: " + PictureFaults.NoHeadsetCode)]
    public async Task Vlc_CodeHalfOutsideThePicture_NamesTheCode(object half, string message) =>
        await RejectedWith(message, "vlc", Picture("half.png", shot => Halved(shot, (CodeKind)half)));

    [Test]
    public async Task Vlc_EmptyFolder_ReportsThatItContainsNoPictures() =>
        await RefusedWith("nothing: contains no pictures", "vlc", Directory.CreateDirectory(Path.Combine(Folder, "nothing")).FullName);

    string ProfileOfAnother(string device)
    {
        var path = Path.Combine(Folder, "earlier.json");
        LatencyProfileFile.Save(path, Profile(device));
        return path;
    }

    string ProfileOfAnotherVersion()
    {
        var path = ProfileOfAnother("");
        File.WriteAllText(path, File.ReadAllText(path).Replace("\"version\": 1", "\"version\": 2", StringComparison.Ordinal));
        return path;
    }

    // The picture file is empty, so this error shows that the profile is checked before any picture is read.
    [Test]
    public async Task Vlc_EarlierProfileHasAnotherVersion_FailsBeforeReadingPictures() => await RefusedWith(
        "earlier.json: " + ProfileMessages.NewerVersion(2, 1), "vlc", Write("a.png", []), "--profile", ProfileOfAnotherVersion());

    [Test]
    public async Task Vlc_EarlierProfileOfAnotherDevice_FailsBeforeReadingPictures() => await RefusedWith(
        "earlier.json: " + ConditionMessages.OtherDevice("Quest 3", "HoloLens 2"),
        "vlc", Write("a.png", []), "--sweep", Write("sweep.csv", [SweepLog.Header, "5,0,4,display_gpu_time,HoloLens 2,60"]),
        "--profile", ProfileOfAnother("Quest 3"));

    [Test]
    public async Task Sine_EarlierProfileHasAnotherVersion_Fails() => await RefusedWith(
        ProfileMessages.NewerVersion(2, 1), "sine", Write("jog.csv", []), "--visu-ms", "40", "--profile", ProfileOfAnotherVersion());

    [Test]
    public async Task Nudge_EarlierProfileHasAnotherVersion_Fails() =>
        await RefusedWith(ProfileMessages.NewerVersion(2, 1), [.. Nudge, "--profile", ProfileOfAnotherVersion()]);

    [Test]
    public async Task Nudge_EarlierProfileOfAnotherDevice_Fails() => await RefusedWith(
        ConditionMessages.OtherDevice("Quest 3", "HoloLens 2"),
        [.. Nudge, "--device", "HoloLens 2", "--profile", ProfileOfAnother("Quest 3")]);

    [TestCase("0")]
    [TestCase("NaN")]
    public async Task Range_InvalidRenderTime_NamesFileLineAndField(string renderMs) => await RefusedWith(
        "pairs.csv:2: render_ms: ", "range", Write("pairs.csv", ["render_ms,visu_ms", .. Enumerable.Repeat(renderMs + ",40", 30)]));
}
