using System.Text.Json;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests <c>demo --virtual</c>: its files, its statements about virtual time, and its repeats.</summary>
public sealed class VirtualDemoTests
{
    TemporaryFolder _folder;

    [SetUp]
    public void CreateFolder() => _folder = new TemporaryFolder();

    [TearDown]
    public void DeleteFolder() => _folder.Dispose();

    static Task<CliRun> RunIn(string folder, params string[] options) =>
        CliRun.OfAsync(["demo", "--virtual", "--seconds", "8", "--network", "lan", "--predictor", "quadratic", "--out", folder, .. options]);

    async Task<(CliRun Run, JsonElement Result)> ResultOf(params string[] options)
    {
        var run = await RunIn(_folder.Path, options);
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(Text("result.json"));
        return (run, json.RootElement.Clone());
    }

    string Text(string file) => File.ReadAllText(Path.Combine(_folder.Path, file));

    [Test]
    public async Task Run_Twice_WritesTheSameFiles()
    {
        string[] files = ["result.json", "report.html", "session.jsonl"];
        await ResultOf("--seed", "3");
        var first = Array.ConvertAll(files, Text);

        await ResultOf("--seed", "3");

        Assert.That(Array.ConvertAll(files, Text), Is.EqualTo(first));
    }

    [Test]
    public async Task Run_ResultAndReport_HaveNumbersOfTenDigits()
    {
        var (_, result) = await ResultOf();

        var digits = result.GetProperty("tool_error_mm").EnumerateObject().Where(number => number.Value.ValueKind == JsonValueKind.Number)
            .Select(number => number.Value.GetRawText().Replace(".", "").TrimStart('0').Length);
        Assert.That(digits, Is.All.LessThanOrEqualTo(10), "the other digits differ between machines");
        Assert.That(Text("report.html"), Does.Match("\"compensated\":[0-9]").And.Not.Match("\"(un)?compensated\":[0-9]*\\.?[0-9]{11}"));
    }

    [Test]
    public async Task Run_OtherSeed_HasOtherErrors()
    {
        var (_, one) = await ResultOf("--seed", "1");
        var (_, two) = await ResultOf("--seed", "2");

        Assert.That(Number(two, "tool_error_mm", "rms"), Is.Not.EqualTo(Number(one, "tool_error_mm", "rms")));
    }

    [Test]
    public async Task Run_Complete_StatesVirtualTimeAndItsMissingParts()
    {
        var (run, result) = await ResultOf();

        var conditions = result.GetProperty("conditions");
        Assert.That(conditions.GetProperty("time").GetString(), Is.EqualTo("virtual"));
        Assert.That(conditions.GetProperty("not_included").Deserialize<string[]>(), Is.EqualTo(DemoTexts.NotInVirtualTime));
        Assert.That(result.GetProperty("frame").EnumerateObject().Select(field => field.Value.ValueKind), Has.Exactly(3).EqualTo(JsonValueKind.Null));
        Assert.That(run.Output, Does.Contain(DemoTexts.Title("youbot", "quadratic", "lan", isVirtual: true)));
        Assert.That(Unbroken(run.Output), Does.Contain(Unbroken(DemoTexts.VirtualTime)));
        Assert.That(run.Output, Does.Not.Contain(DemoTexts.FrameDuration));
        Assert.That(Text("report.html"), Does.Contain(DemoTexts.VirtualSubtitle).And.Not.Contain(DemoTexts.FrameDuration));
    }

    // The console breaks long values.
    static string Unbroken(string text) => string.Concat(text.Where(c => !char.IsWhiteSpace(c)));

    [Test]
    public async Task Run_Trajectory_RecordsASessionThatReplayReads()
    {
        var (_, result) = await ResultOf("--trajectory");

        var replay = await CliRun.OfAsync("replay", Path.Combine(_folder.Path, "session.jsonl"), "--predictor", "quadratic", "--json");

        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
        Assert.That(JsonDocument.Parse(replay.Output).RootElement.GetProperty("frames").GetInt32(), Is.GreaterThan(300));
        Assert.That(Text("session.jsonl"), Does.Contain("{\"kind\":\"plan\"").And.Not.Contain("{\"kind\":\"lost\""));
        Assert.That(Text("session.jsonl").TrimEnd().Split('\n')[^1], Does.Contain("\"closed\""));
        Assert.That(Number(result, "tool_error_mm", "reduction"), Is.GreaterThan(0.99), "the set-points are those of the robot");
    }

    [Test]
    public async Task Repeats_Three_HaveMeanMinimumAndMaximumOfTheSeeds()
    {
        double[] values = new double[3];
        for (var i = 0; i < values.Length; i++)
            values[i] = Number((await ResultOf("--seed", (5 + i).ToString())).Result, "tool_error_mm", "rms");

        var (run, result) = await ResultOf("--seed", "5", "--repeats", "3");

        var repeats = result.GetProperty("repeats");
        Assert.That(repeats.GetProperty("seeds").Deserialize<int[]>(), Is.EqualTo(new[] { 5, 6, 7 }));
        var figure = repeats.GetProperty("figures").GetProperty("tool_error_mm.rms");
        Assert.That(figure.GetProperty("values").Deserialize<double[]>(), Is.EqualTo(values));
        Assert.That(Number(figure, "mean"), Is.EqualTo(values.Average()).Within(1e-8));
        Assert.That((Number(figure, "min"), Number(figure, "max")), Is.EqualTo((values.Min(), values.Max())));
        var names = repeats.GetProperty("figures").EnumerateObject().Select(each => each.Name);
        Assert.That(names, Has.None.StartsWith("frame.").And.None.StartsWith("conditions."));
        Assert.That(Number(result, "tool_error_mm", "rms"), Is.EqualTo(values[0]), "the other results are those of the first repeat");
        Assert.That(run.Output, Does.Contain("tool_error_mm.rms").And.Contain(DemoTexts.Seeds(5, 7)));
    }

    [Test]
    public void Repeats_SomeWithoutAValue_AreTheFiguresOfTheOthers()
    {
        var figures = DemoRepeats.Of([Of(3), Of(null), Of(5)]).Figures;

        Assert.That(figures["tool_error_mm.rms"].Values, Is.EqualTo(new double?[] { 3, null, 5 }));
        Assert.That((figures["tool_error_mm.rms"].Mean, figures["tool_error_mm.rms"].Min), Is.EqualTo((4, 3)));
        Assert.That(figures.Keys, Has.None.EqualTo("tool_error_mm.p95"));
    }

    static DemoResult Of(double? rms) => new(
        8, 480, 160, 0, "lan", new(80, 100, 40, 1), new(1, 2, 3, 0, 1, 1, 1), new(null, null, rms, null, null, null, null, null),
        new(null, null, null), new(null, null, null, null, null), null, new(null, null, null), null)
    {
        Conditions = DemoConditions.Of(Settings),
    };

    static DemoSettings Settings => DemoVerb.Settings(DemoVerb.Create().Parse(["--virtual"]));

    [Test]
    public async Task Finish_RepeatsInterrupted_NotesItAndReturns130()
    {
        var run = await DemoStage.PlayAsync(Settings with { Seconds = 5, Predictor = "quadratic" }, recordingPath: null, CancellationToken.None);
        var missing = DemoMessages.FiguresInterrupted(1, 3);
        using var output = DemoOutput.At(_folder.Path, isPaper: false);

        var (status, _, _) = await CapturedConsole.OfAsync(() => Task.FromResult(
            DemoVerb.Finish(run, output, isInterrupted: false, DemoRepeats.Of([new DemoScore(run).Result()]), missing)));

        Assert.That(status, Is.EqualTo(130));
        Assert.That(JsonDocument.Parse(Text("result.json")).RootElement.GetProperty("notes").Deserialize<string[]>(), Is.EqualTo(new[] { missing }));
    }

    [Test]
    public async Task PlayAsync_Cancelled_EndsAtOnce()
    {
        var run = await DemoStage.PlayAsync(Settings with { Seconds = 3600 }, recordingPath: null, new CancellationToken(canceled: true));

        Assert.That(run.Frames.Rows, Is.Empty);
    }

    static readonly string[][] Contradicting =
    [
        ["--load 1000000", "--load: " + DemoMessages.NotWithVirtual],
        ["--paper", "--paper: " + DemoMessages.NotWithVirtual],
        ["--sampling-ms 4", DemoMessages.SamplingWithVirtual(4, 5)],
    ];

    [TestCaseSource(nameof(Contradicting))]
    public async Task Run_ContradictingOption_PrintsOneLineAndExitsWith2(string options, string message)
    {
        var folder = Path.Combine(_folder.Path, "none");

        var run = await RunIn(folder, options.Split(' '));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(message));
        Assert.That(Directory.Exists(folder), Is.False);
    }

    static double Number(JsonElement element, params string[] path) => path.Aggregate(element, (at, name) => at.GetProperty(name)).GetDouble();
}
