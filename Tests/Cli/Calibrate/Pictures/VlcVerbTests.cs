using System.Globalization;
using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>Tests the command <c>calibrate vlc</c>, which reads pictures and writes a latency profile. Needs Node.js, as the build does.</summary>
public sealed class VlcVerbTests
{
    /// <summary>A grey PNG of one pixel.</summary>
    static readonly byte[] OnePixel = Convert.FromBase64String(
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg==");

    string _folder;

    [OneTimeSetUp]
    public async Task TakePictures()
    {
        _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        var run = await CliRun.OfAsync(
            "calibrate", "simulate", "--pictures", "24", "--spoiled", "0.05", "--seed", "11", "--out", _folder);
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
    }

    [OneTimeTearDown]
    public void RemovePictures() => Directory.Delete(_folder, true);

    string In(string name) => Path.Combine(_folder, name);

    Task<CliRun> Run(params string[] arguments) => CliRun.OfAsync(["calibrate", "vlc", "--out", In("out"), .. arguments]);

    [Test]
    public async Task Vlc_SimulatedSweep_ReturnsTheTrueLatencyOfEachPicture()
    {
        var run = await Run(In("pictures"), "--sweep", In("sweep.csv"), "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        var pictures = json.RootElement.GetProperty("per_picture").EnumerateArray().ToList();
        var truth = File.ReadLines(In("truth.csv")).Skip(1).Select(line => double.Parse(line.Split(',')[3], CultureInfo.InvariantCulture)).ToList();
        var errors = pictures.Zip(truth).Where(pair => pair.First.GetProperty("visu_ms").ValueKind == JsonValueKind.Number)
            .Select(pair => pair.First.GetProperty("visu_ms").GetDouble() - pair.Second).ToList();
        Assert.That(errors, Has.Count.GreaterThan(0.75 * pictures.Count));
        Assert.That(errors, Has.Count.EqualTo(json.RootElement.GetProperty("decoded").GetInt32()));
        Assert.That(errors.Select(Math.Abs).Max(), Is.LessThan(2));
        Assert.That(errors.Average(), Is.EqualTo(0).Within(0.4));
        Assert.That(json.RootElement.GetProperty("pictures").GetInt32(), Is.EqualTo(24));
        Assert.That(json.RootElement.GetProperty("rejected").GetInt32(), Is.EqualTo(24 - errors.Count));
        var profile = LatencyProfileFile.Load(In("out/profile.json"));
        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(40).Within(1));
        Assert.That(profile.Method, Is.EqualTo(CalibrationMethod.VisibleLight));
        Assert.That(File.ReadLines(In("out/pairs.csv")).Count(), Is.GreaterThan(0.7 * 24));
    }

    [Test]
    public async Task Vlc_NoSweep_WritesAProfileWithoutLimit()
    {
        string[] pictures = [.. Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).Take(4)];

        var run = await Run(pictures);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Contain("L_visu is "));
        Assert.That(MessageNumbers.In(run.Errors, VlcMessages.FewPictures(0))[0], Is.InRange(2, 4));
        Assert.That(LatencyProfileFile.Load(In("out/profile.json")).Range, Is.Null);
    }

    [Test]
    public async Task Vlc_FileIsNotAPicture_ReportsTheFileAndKeepsTheProfile()
    {
        Directory.CreateDirectory(In("out"));
        File.WriteAllText(In("out/profile.json"), "good");
        File.WriteAllText(In("text.png"), "not a picture");

        var run = await Run(In("text.png"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.Contain("text.png").And.Contain("neither a PNG nor a JPEG"));
        Assert.That(File.ReadAllText(In("out/profile.json")), Is.EqualTo("good"));
    }

    [TestCase("0", 0)]
    [TestCase("NaN", double.NaN)]
    [TestCase("1001", 1001)]
    public async Task Vlc_OneInvalidRenderTime_NamesItAndKeepsTheProfile(string renderMs, double named)
    {
        Directory.CreateDirectory(In("out"));
        File.WriteAllText(In("out/profile.json"), "good");
        var rows = File.ReadAllLines(In("sweep.csv"));
        rows[100] = string.Join(',', rows[100].Split(',') is var fields ? [.. fields[..2], renderMs, .. fields[3..]] : []);
        File.WriteAllLines(In("bad.csv"), rows);

        var run = await Run(In("pictures"), "--sweep", In("bad.csv"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.Trim(),
            Is.EqualTo(ConsoleMessages.Line(SettingMessages.OutOfRange($"{In("bad.csv")}:101: render_ms", named, " ms", 0.001, 1000))));
        Assert.That(File.ReadAllText(In("out/profile.json")), Is.EqualTo("good"));
    }

    [TestCase(new byte[] { 0xff, 0xd8, 0xff }, "the file is incomplete")]
    [TestCase(new byte[] { 0x89, 0x50 }, "neither a PNG nor a JPEG")]
    public async Task Vlc_PictureOfAFewBytes_StatesTheReason(byte[] bytes, string expected)
    {
        File.WriteAllBytes(In("short.jpg"), bytes);

        Assert.That((await Run(In("short.jpg"))).Errors, Does.Contain("short.jpg: unreadable: ").And.Contain(expected));
    }

    [Test]
    public async Task Vlc_TruncatedOrDamagedPicture_ReportsTheFault()
    {
        var whole = File.ReadAllBytes(In("pictures/picture-00001.jpg"));
        var tables = whole.AsSpan().IndexOf([(byte)0xff, (byte)0xc4]);
        File.WriteAllBytes(In("a.jpg"), whole[..(tables + 6)]);
        // A decoder would fill the missing lower half with other pixels.
        File.WriteAllBytes(In("b.jpg"), whole[..(whole.Length / 2)]);
        whole.AsSpan(tables + 4, 60).Fill(0x11);
        File.WriteAllBytes(In("c.jpg"), whole);

        string[] good = [.. Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).Take(2)];

        var run = await Run([In("a.jpg"), In("b.jpg"), In("c.jpg"), .. good]);

        Assert.That(run.Errors, Does.Contain("a.jpg: unreadable: the file is incomplete").And.Contain("b.jpg: unreadable: the file is incomplete"));
        Assert.That(run.Errors, Does.Contain("c.jpg: unreadable: the picture is damaged or incomplete"));
    }

    [Test]
    public async Task Vlc_PictureWithTooManyPixels_RejectsOnlyThatPicture()
    {
        var huge = new byte[64];
        byte[] start = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, .. "IHDR"u8, 0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30, 1];
        start.CopyTo(huge, 0);
        File.WriteAllBytes(In("huge.png"), huge);
        string[] pictures = [.. Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).Take(2)];

        var run = await Run([In("huge.png"), .. pictures]);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(run.Errors, Does.Contain("huge.png: unreadable: 30000x30000 pixels are too many"));
    }

    [Test]
    public async Task Vlc_PictureOfAnotherSize_RejectsItAndStatesBothSizes()
    {
        // Comes before the other pictures.
        File.WriteAllBytes(In("a.png"), OnePixel);
        string[] good = [.. Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).Take(2)];

        var run = await Run([In("a.png"), .. good]);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(run.Errors, Does.Contain("a.png: " + PictureFaults.OtherSize(1, 1, 1280, 720)));
    }

    // Compares the complete result, including pictures that are rejected because they are empty or have another size.
    [Test]
    public async Task Vlc_ShuffledPictures_GiveTheSameJson()
    {
        string[] files = [.. Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).Take(4), In("none.jpg"), In("small.png")];
        File.WriteAllBytes(In("none.jpg"), []);
        File.WriteAllBytes(In("small.png"), OnePixel);
        async Task<string> ResultOf(string[] given)
        {
            var run = await Run([.. given, "--sweep", In("sweep.csv"), "--json"]);
            using var json = JsonDocument.Parse(run.Output);
            var sorted = json.RootElement.EnumerateObject().SelectMany<JsonProperty, string>(field => field.Value.ValueKind == JsonValueKind.Array
                ? field.Value.EnumerateArray().Select(each => each.GetRawText()).Order(StringComparer.Ordinal)
                : [$"{field.Name} {(field.Value.ValueKind == JsonValueKind.Number ? Math.Round(field.Value.GetDouble(), 9) : field.Value)}"]);
            return run.ExitStatus + "\n" + string.Join("\n", sorted);
        }
        var shuffled = files.ToArray();
        new Random(5).Shuffle(shuffled);

        var expected = await ResultOf(files);

        Assert.That(expected, Does.Contain("none.jpg").And.Contain(PictureFaults.OtherSize(1, 1, 1280, 720)));
        Assert.That(await ResultOf(shuffled), Is.EqualTo(expected));
    }

    [Test]
    public async Task Vlc_NoPictureReadable_ListsAllPicturesWithTheirReasons()
    {
        var folder = Directory.CreateDirectory(In("heic")).FullName;
        for (var i = 0; i < 30; i++) File.WriteAllText(Path.Combine(folder, $"a-rather-long-name-{i}.HEIC"), "0000ftypheic");

        var table = await Run(folder);
        var run = await Run(folder, "--json");

        Assert.That((run.ExitStatus, table.ExitStatus), Is.EqualTo((2, 2)), run.Errors);
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(VlcMessages.NothingRead(30, 30, "")).And.Contain("HEIC"));
        using var json = JsonDocument.Parse(run.Output);
        Assert.That(json.RootElement.GetProperty("rejected_pictures").GetArrayLength(), Is.EqualTo(30));
        Assert.That(json.RootElement.GetProperty("visu_ms_mean").ValueKind, Is.EqualTo(JsonValueKind.Null));
        var page = await File.ReadAllTextAsync(In("out/calibration.html"));
        for (var i = 0; i < 30; i++) Assert.That(page, Does.Contain($"a-rather-long-name-{i}.HEIC"));
        for (var i = 0; i < 30; i++) Assert.That(table.Output, Does.Contain($"a-rather-long-name-{i}.HEIC"));
    }

    [Test]
    public async Task Vlc_SinglePicture_FailsWithoutAProfile()
    {
        var one = Directory.GetFiles(In("pictures")).Order(StringComparer.Ordinal).First();

        var run = await Run(one, "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(VlcMessages.OnePicture));
        using var json = JsonDocument.Parse(run.Output);
        Assert.That(json.RootElement.GetProperty("decoded").GetInt32(), Is.EqualTo(1));
    }

    [TestCase("nowhere", "file or folder not found")]
    [TestCase("empty", "contains no pictures")]
    [TestCase("sweep.csv", "neither a picture")]
    [TestCase("broken.png", "broken.png: unreadable")]
    public async Task Vlc_NoReadablePictures_ReportsTheReasonInOneLine(string name, string expected)
    {
        Directory.CreateDirectory(In("empty"));
        File.WriteAllBytes(In("broken.png"), [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0]);

        var run = await Run(In(name));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.Contain(name).And.Contain(expected));
    }
}
