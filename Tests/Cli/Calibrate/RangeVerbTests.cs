using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Cli.Calibrate;
using Nowpose.Latency;
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

        Assert.That(() => RangeVerb.Run(parsed, new CancellationToken(canceled: true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(Directory.Exists(Out), Is.False);
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
        Assert.That(table.Output, Does.Contain("limit not reached"));
        Assert.That(new[] { json.Errors, table.Errors }, Has.All.Contain("extend the sweep to a higher load"));
        Assert.That(LatencyProfileFile.Load(ProfilePath).Range, Is.Null);
    }

    [Test]
    public async Task Range_RenderTimeIndependentOfTheLoad_Fails()
    {
        var blind = Sweep(7, 2).Select((line, i) => i == 0 ? line : string.Join(',', line.Split(',') is var fields ? [fields[0], fields[1], "3.1", fields[3]] : []));

        Assert.That(await RefusalOf("range", Write("pairs.csv", blind)), Does.Contain("this source does not respond to load").And.Contain("display_gpu_time was 3.10 ms"));
        Assert.That(File.Exists(ProfilePath), Is.False);
    }

    [Test]
    public async Task Range_FewLoads_StatesTheRangeOfTheLimit()
    {
        var coarse = Sweep(7, 2).Where((line, i) => i == 0 || int.Parse(line.Split(',')[1], CultureInfo.InvariantCulture) % 500_000 == 0);

        var run = await CliRun.OfAsync("calibrate", "range", Write("pairs.csv", coarse), "--out", Out);

        Assert.That(run.Errors, Does.Match(@"the limit is between 1[345]\.\d\d ms, which is used, and 1[567]\.\d\d ms"));
    }

    [TestCase("render_ms,visu_ms\n5,40\n0,40", ":3: render_ms: 0 ms is out of range; allowed: 0.001 to 1000 ms")]
    [TestCase("render_ms,visu_ms\nNaN,40", ":2: render_ms: NaN ms is out of range")]
    [TestCase("render_ms,visu_ms\n5,4o", ":2: visu_ms: '4o' is not a number")]
    [TestCase("render_ms,visu_ms\n5", ":2: 1 fields; the header has 2")]
    [TestCase("render_ms,visu_ms\n5,40\n\n\"6,40\n7,40\n8,40", ":4: 1 fields; the header has 2")]
    [TestCase("render,visu_ms\n5,40", ":1: no column render_ms")]
    [TestCase("render_ms,visu_ms,render_ms\n5,40,5", ":1: column render_ms occurs twice")]
    [TestCase("vertices,render_ms,visu_ms\n-5,5,40", ":2: vertices: '-5' is not a whole number")]
    [TestCase("render_ms,visu_ms", "no rows")]
    [TestCase("render_ms,visu_ms\n5,40\n6,40", "2 are too few")]
    [TestCase("", ":1: no column render_ms")]
    public async Task Range_InvalidTable_NamesFileLineAndField(string text, string named)
    {
        var file = Write("pairs.csv", [text]);

        Assert.That(await RefusalOf("range", file), Does.StartWith("nowpose: " + file).And.Contain(named));
    }

    [Test]
    public async Task Range_InvalidTable_KeepsTheExistingProfile()
    {
        await CliRun.OfAsync("calibrate", "range", Write("good.csv", Sweep(9, 2)), "--out", Out);
        var before = await File.ReadAllBytesAsync(ProfilePath);

        await RefusalOf("range", Write("bad.csv", ["render_ms,visu_ms", "0,0"]));

        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(before));
    }

    [TestCase("0", "0 ms")]
    [TestCase("NaN", "NaN ms")]
    [TestCase("-4.2", "-4.2 ms")]
    [TestCase("1001", "1001 ms")]
    public async Task Range_OneInvalidRenderTime_NamesItAndKeepsTheProfile(string renderMs, string named)
    {
        var good = Sweep(9, 2).ToArray();
        await CliRun.OfAsync("calibrate", "range", Write("good.csv", good), "--out", Out);
        var before = await File.ReadAllBytesAsync(ProfilePath);
        good[300] = string.Join(',', good[300].Split(',') is var fields ? [fields[0], fields[1], renderMs, fields[3]] : []);
        var bad = Write("bad.csv", good);

        var refusal = await RefusalOf("range", bad);

        Assert.That(refusal, Is.EqualTo($"nowpose: {bad}:301: render_ms: {named} is out of range; allowed: 0.001 to 1000 ms"));
        Assert.That(await File.ReadAllBytesAsync(ProfilePath), Is.EqualTo(before));
    }

    [TestCase("--source", "guess", "--source: 'guess' is unknown")]
    [TestCase("--display-hz", "-1", "--display-hz: -1 Hz is out of range")]
    public async Task Range_InvalidOption_StatesTheAllowedValues(string option, string value, string named) =>
        Assert.That(await RefusalOf("range", Write("pairs.csv", Sweep(1, 1)), option, value), Does.Contain(named));
}
