using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public class RangeVerbTests : CalibrationFolder
{
    const double TrueLimitMs = 1000 / 60.0 - 1.5;

    static IEnumerable<string> Sweep(int seed, double maxMillions)
    {
        var random = new Random(seed);
        var pipeline = new DisplayPipeline(seed, new DisplayPipelineSettings(plateauMs: 40));
        yield return "file,vertices,render_ms,visu_ms";
        for (var vertices = 0.0; vertices <= maxMillions * 1e6; vertices += 100_000)
            for (var i = 0; i < 30; i++)
            {
                var frame = pipeline.Next(vertices);
                yield return string.Create(CultureInfo.InvariantCulture,
                    $"{i}.png,{vertices},{frame.RenderTime.TotalMilliseconds:0.###},{frame.Visualisation.TotalMilliseconds + random.NextDouble() - 0.5:0.##}");
            }
    }

    [Test]
    public void Run_Cancelled_WritesNothing()
    {
        var parsed = RangeVerb.Create().Parse([Write("pairs.csv", Sweep(7, 2)), "--out", Out]);

        Assert.That(() => RangeVerb.RunAsync(parsed, new CancellationToken(canceled: true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(Directory.Exists(Out), Is.False);
    }

    [Test]
    public async Task Range_TimesInSeconds_AreRefusedWithTheFile()
    {
        var file = Write("pairs.csv", ["render_ms,visu_ms", .. Enumerable.Range(1, 40).Select(i => FormattableString.Invariant($"{1e-3 * i},0.04"))]);

        var run = await CliRun.OfAsync("calibrate", "range", file, "--out", Out);

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Errors, Does.StartWith($"nowpose: {file}: "));
        Assert.That(File.Exists(ProfilePath), Is.False);
    }

    [Test]
    public async Task Range_SweepAcrossTheLimit_WritesProfilePageAndJson()
    {
        var file = Write("pairs.csv", Sweep(7, 2));

        var run = await CliRun.OfAsync("calibrate", "range", file, "--json", "--source", "engine_gpu_time", "--device", "Quest 3", "--display-hz", "72", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        var json = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(json.EnumerateObject().Select(p => p.Name),
            Is.EqualTo(new[] { "visu_ms", "visu_spread_ms", "limit_render_ms", "valid_to_render_ms", "pairs", "rejected" }));
        Assert.That(json.GetProperty("limit_render_ms").GetDouble(), Is.InRange(0.94 * TrueLimitMs, 1.02 * TrueLimitMs));
        Assert.That(json.GetProperty("visu_ms").GetDouble(), Is.EqualTo(40).Within(0.2));
        Assert.That(json.GetProperty("pairs").GetInt32(), Is.EqualTo(630));
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.RefusalFor("Quest 3", 72), Is.Null);
        Assert.That(profile.Measurements, Is.InRange(100, 500), "only the pictures within the limit are counted");
        Assert.That(profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.EngineGpuTime));
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.EqualTo(json.GetProperty("limit_render_ms").GetDouble()).Within(1e-3));
        var page = await File.ReadAllTextAsync(Path.Combine(Out, "calibration.html"));
        using var data = JsonDocument.Parse(Regex.Match(page, "id=\"report-data\">(.*?)</script>", RegexOptions.Singleline).Groups[1].Value);
        Assert.That(data.RootElement.GetProperty("sections").EnumerateArray().Select(section => section.GetProperty("source").GetString()),
            Is.EqualTo(new[] { "Fig. 10", "Fig. 11a", "Fig. 11b" }));
    }

    [Test]
    public async Task Range_AllLoadsBelowTheLimit_ReportsThatNoLimitWasReached()
    {
        var file = Write("pairs.csv", Sweep(8, 1));

        var json = await CliRun.OfAsync("calibrate", "range", file, "--json", "--out", Out);
        var table = await CliRun.OfAsync("calibrate", "range", file, "--out", Out);

        Assert.That(JsonDocument.Parse(json.Output).RootElement.GetProperty("limit_render_ms").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(table.Output, Does.Contain(RangeMessages.NoLimit.Split(':')[0]));
        Assert.That(new[] { json.Errors, table.Errors }, Has.All.Contain(RangeMessages.NoLimit));
        Assert.That(LatencyProfileFile.Load(ProfilePath).Range, Is.Null);
    }

    [Test]
    public async Task Range_RenderTimeIndependentOfTheLoad_Fails()
    {
        var blind = Sweep(7, 2).Select((line, i) => i == 0 ? line : string.Join(',', line.Split(',') is var fields ? [fields[0], fields[1], "3.1", fields[3]] : []));

        var file = Write("pairs.csv", blind);
        var expected = RangeMessages.SourceDoesNotRespond(file, "display_gpu_time", 3.1, 3.1);
        Assert.That(await RefusalOf("range", file), Is.EqualTo(ConsoleMessages.Line(expected)));
        Assert.That(File.Exists(ProfilePath), Is.False);
    }

    [Test]
    public async Task Range_FewLoads_StatesTheRangeOfTheLimit()
    {
        var coarse = Sweep(7, 2).Where((line, i) => i == 0 || int.Parse(line.Split(',')[1], CultureInfo.InvariantCulture) % 500_000 == 0);

        var run = await CliRun.OfAsync("calibrate", "range", Write("pairs.csv", coarse), "--out", Out);

        var limits = MessageNumbers.In(run.Errors, RangeMessages.LimitBetween(0, 0));
        Assert.That(limits[0], Is.InRange(13, 16));
        Assert.That(limits[1], Is.InRange(15, 18));
    }

    static IEnumerable<string> SweepOf(string source, string device) =>
        Sweep(7, 2).Select((line, i) => line + (i == 0 ? ",source,device,display_hz,graphics_api" : $",{source},{device},90,Vulkan"));

    [Test]
    public async Task Range_TableWithItsOrigin_WritesItToTheProfile()
    {
        var run = await CliRun.OfAsync("calibrate", "range", Write("pairs.csv", SweepOf("engine_gpu_time", "Quest 3")), "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.EngineGpuTime));
        Assert.That((profile.RefusalFor("Quest 3", 90), profile.Conditions.GraphicsApi), Is.EqualTo(((string)null, "Vulkan")));
        Assert.That(profile.RefusalFor("HoloLens 2", 90), Is.Not.Null);
    }

    [Test]
    public async Task Range_OptionDiffersFromTheTable_IsRefusedForTheSourceAndElseWarnsOnly()
    {
        var file = Write("pairs.csv", SweepOf("engine_gpu_time", "Quest 3"));

        Assert.That(
            await RefusalOf("range", file, "--source", "display_gpu_time"),
            Is.EqualTo(ConsoleMessages.Line(PairFileMessages.OtherSource(file, "display_gpu_time", "engine_gpu_time"))));
        var run = await CliRun.OfAsync("calibrate", "range", file, "--device", "HoloLens 2", "--out", Out);

        Assert.That(run.Complaints, Has.One.EqualTo(ConsoleMessages.Line(PairFileMessages.OtherCondition(file, "device", "Quest 3", "HoloLens 2"))));
        Assert.That(LatencyProfileFile.Load(ProfilePath).Device, Is.EqualTo("HoloLens 2"));
    }

    [Test]
    public async Task Range_TableOfTwoHeadsets_IsRefused()
    {
        var file = Write("pairs.csv", SweepOf("gpu_completion", "A").Take(41).Concat(SweepOf("gpu_completion", "B").Skip(41)));

        Assert.That(await RefusalOf("range", file), Is.EqualTo(ConsoleMessages.Line($"{file}:42: " + PairFileMessages.TwoOrigins("device", "A", "B"))));
    }

    static readonly string[][] InvalidTables =
    [
        ["render_ms,visu_ms,source\n5,40,\n5,40,guess", ":3: " + SweepFileMessages.UnknownSource("source", "guess", LatencyNames.RenderTimeSource.All)],
        ["render_ms,visu_ms\n5,40\n0,40", ":3: " + InvalidRenderTime(0)],
        ["render_ms,visu_ms\nNaN,40", ":2: " + InvalidRenderTime(double.NaN)],
        ["render_ms,visu_ms\n5,NaN", ":2: " + InvalidVisu(double.NaN)],
        ["render_ms,visu_ms\n5,65537", ":2: " + InvalidVisu(65_537)],
        ["render_ms,visu_ms\n5,4o", ":2: " + TableMessages.NotANumber("visu_ms", "4o", "milliseconds")],
        ["render_ms,visu_ms\n5", ":2: " + TableMessages.FieldCount(1, 2)],
        ["render_ms,visu_ms\n5,40\n\n\"6,40\n7,40\n8,40", ":4: " + TableMessages.FieldCount(1, 2)],
        ["render,visu_ms\n5,40", ":1: " + PairFileMessages.NoColumn("render_ms", "render_ms", "visu_ms")],
        ["render_ms,visu_ms,render_ms\n5,40,5", ":1: " + PairFileMessages.ColumnTwice("render_ms")],
        ["vertices,render_ms,visu_ms\n-5,5,40", ":2: " + PairFileMessages.NotVertices("vertices", "-5", 1_000_000_000)],
        ["render_ms,visu_ms", TableMessages.NoRows("", 20)],
        ["render_ms,visu_ms\n5,40\n6,40", ": " + RangeMessages.TooFewPairs(2, 20)],
        ["", ":1: " + PairFileMessages.NoColumn("render_ms", "render_ms", "visu_ms")],
    ];

    static string InvalidRenderTime(double ms) => SettingMessages.OutOfRange("render_ms", ms, " ms", 0.001, 1000);

    static string InvalidVisu(double ms) => SettingMessages.OutOfRange("visu_ms", ms, " ms", -65_536, 65_536);

    [TestCaseSource(nameof(InvalidTables))]
    public async Task Range_InvalidTable_NamesFileLineAndField(string text, string message)
    {
        var file = Write("pairs.csv", [text]);

        Assert.That(await RefusalOf("range", file), Is.EqualTo(ConsoleMessages.Line(file + message)));
    }

    [Test]
    public async Task Range_InvalidTable_KeepsTheExistingProfile()
    {
        await CliRun.OfAsync("calibrate", "range", Write("good.csv", Sweep(9, 2)), "--out", Out);
        var before = await File.ReadAllBytesAsync(ProfilePath);

        await RefusalOf("range", Write("bad.csv", ["render_ms,visu_ms", "0,0"]));

        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(before));
    }

    [TestCase("0", 0)]
    [TestCase("NaN", double.NaN)]
    [TestCase("-4.2", -4.2)]
    [TestCase("1001", 1001)]
    public async Task Range_OneInvalidRenderTime_NamesItAndKeepsTheProfile(string renderMs, double named)
    {
        var good = Sweep(9, 2).ToArray();
        await CliRun.OfAsync("calibrate", "range", Write("good.csv", good), "--out", Out);
        var before = await File.ReadAllBytesAsync(ProfilePath);
        good[300] = string.Join(',', good[300].Split(',') is var fields ? [fields[0], fields[1], renderMs, fields[3]] : []);
        var bad = Write("bad.csv", good);

        var refusal = await RefusalOf("range", bad);

        Assert.That(refusal, Is.EqualTo(ConsoleMessages.Line($"{bad}:301: {InvalidRenderTime(named)}")));
        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(before));
    }

    [TestCase("--source", "guess", "--source: 'guess' is unknown")]
    [TestCase("--display-hz", "-1", "--display-hz: -1 Hz")]
    public async Task Range_InvalidOption_StatesTheAllowedValues(string option, string value, string named) =>
        Assert.That(await RefusalOf("range", Write("pairs.csv", Sweep(1, 1)), option, value), Does.Contain(named));
}
