using System.Globalization;
using System.Text;
using System.Text.Json;
using Nowpose.Cli;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Recommend;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Headless.Tests.Cli.SessionFiles;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Recommend;

public class RecommendVerbTests
{
    static Task<CliRun> Run(params string[] arguments) => CliRun.OfAsync(["recommend", .. arguments]);

    static string Motion(Func<double, double> position, double seconds = 20)
    {
        var text = new StringBuilder("t,a\n");
        for (var i = 0; i <= seconds * 100; i++)
            text.Append(CultureInfo.InvariantCulture, $"{i / 100.0},{position(i / 100.0)}\n");
        return text.ToString();
    }

    static async Task<JsonElement> JsonOf(params string[] arguments)
    {
        var run = await Run([.. arguments, "--json"]);
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return json.RootElement.Clone();
    }

    static JsonElement Candidate(JsonElement condition, string predictor) => condition.GetProperty("candidates").EnumerateArray()
        .Single(c => c.GetProperty("predictor").GetString() == predictor);

    [Test]
    public async Task Recommend_MotionAsJson_ListsAllPredictorsBestFirst()
    {
        using var file = new TemporaryFile(Motion(Math.Sin), ".csv.gz");

        var result = await JsonOf(file.Path);

        var condition = result.GetProperty("conditions").EnumerateArray().Single();
        var candidates = condition.GetProperty("candidates").EnumerateArray().ToList();
        Assert.That(candidates.Select(c => c.GetProperty("predictor").GetString()), Is.SupersetOf(Predictors.Names));
        Assert.That(candidates.Select(c => c.GetProperty("predictor").GetString()), Is.SupersetOf(new[] { "linear-h2", "quadratic-h6", "cubic-h5" }));
        Assert.That(candidates.Select(c => c.GetProperty("rms").GetDouble()), Is.Ordered);
        Assert.That(condition.GetProperty("sampling_ms").GetDouble(), Is.EqualTo(50));
        Assert.That(condition.GetProperty("latency_ms").GetDouble(), Is.EqualTo(100));
        Assert.That((condition.GetProperty("fps").GetDouble(), condition.GetProperty("phases").GetInt32()), Is.EqualTo((60.0, 5)));
        Assert.That(result.GetProperty("version").GetString(), Is.EqualTo(ProgramVersion.Text));
        Assert.That(Candidate(condition, "hold").GetProperty("reduction").GetDouble(), Is.EqualTo(0));
        Assert.That(condition.GetProperty("blend_cost").GetDouble(), Is.InRange(-0.05, 0.2));
        Assert.That(condition.GetProperty("blend_ms").GetDouble(), Is.EqualTo(condition.GetProperty("blend_cost").GetDouble() > 0.05 ? 0 : 14));
        Assert.That(result.GetProperty("warnings").GetArrayLength(), Is.EqualTo(0));
    }

    [Test]
    public async Task Recommend_HalfOfAMotion_EqualsTheReplayOfThatHalf()
    {
        // Both halves contain the same swing, so half of the travel takes half of the time.
        static double Swing(double t) => Math.Cos(Math.PI * t / 5);
        using var file = new TemporaryFile(Motion(Swing));
        using var half = new TemporaryFile(Motion(Swing, 10));

        var condition = (await JsonOf(file.Path, "--sampling-ms", "40")).GetProperty("conditions")[0];
        var replay = await CliRun.OfAsync("replay", half.Path, "--sampling-ms", "40", "--phases", "5", "--predictor", "quadratic", "--json");

        using var json = JsonDocument.Parse(replay.Output);
        var first = Candidate(condition, "quadratic").GetProperty("halves")[0];
        Assert.That(first.GetProperty("rms").GetDouble(), Is.EqualTo(json.RootElement.GetProperty("rms").GetDouble()).Within(1e-9));
        Assert.That(first.GetProperty("frames").GetInt32(), Is.EqualTo(json.RootElement.GetProperty("frames").GetInt32()));
    }

    [Test]
    public async Task Recommend_RepeatedMotion_SecondHalfUsesWhatThePredictorHasLearned()
    {
        static double Cycle(double t) => Math.Pow(Math.Sin(Math.PI * t / 2), 5);
        using var file = new TemporaryFile(Motion(Cycle));

        var halves = Candidate((await JsonOf(file.Path)).GetProperty("conditions")[0], Predictors.Default).GetProperty("halves");

        Assert.That(halves[1].GetProperty("rms").GetDouble(), Is.LessThan(0.3 * halves[0].GetProperty("rms").GetDouble()));
    }

    // A pass over 500 columns at 60 frames per second has 30 000 values per second. The maximum of all passes is 50 million.
    [TestCase(60, 5)]
    [TestCase(600, 2)]
    [TestCase(1600, 1)]
    public void Phases_LongRecording_AreReduced(double seconds, int phases)
    {
        var header = string.Join(',', Enumerable.Range(0, 500).Select(i => $"j{i}"));
        string Row(double t) => FormattableString.Invariant($"{t},") + string.Join(',', Enumerable.Repeat(FormattableString.Invariant($"{t}"), 500));
        using var file = new TemporaryFile($"t,{header}\n{Row(0)}\n{Row(seconds)}\n", ".csv");

        Assert.That(new MotionSubject(file.Path, MotionRecording.Read(file.Path), 50, 100).Phases, Is.EqualTo(phases));
    }

    [Test]
    public async Task Recommend_GridOption_EvaluatesThreeConditions()
    {
        using var file = new TemporaryFile(Motion(Math.Sin));

        var conditions = (await JsonOf(file.Path, "--grid")).GetProperty("conditions").EnumerateArray();

        Assert.That(
            conditions.Select(c => c.GetProperty("sampling_ms").GetDouble() + "/" + c.GetProperty("latency_ms").GetDouble()),
            Is.EqualTo(new[] { "20/100", "50/100", "100/150" }));
    }

    [Test]
    public async Task Recommend_Motion_PrintsTheRecommendation()
    {
        using var file = new TemporaryFile(Motion(Math.Sin));

        var run = await Run(file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Match(@"Use predictor [\w-]+: .*\."));
        static string Blend(double ms) => MessagePattern.Of(RecommendTexts.Blend(ms, 14, MessagePattern.Any, MessagePattern.Any, MessagePattern.Any));
        // The console breaks the sentence at the end of a line.
        Assert.That(run.Output.Replace("\n", "", StringComparison.Ordinal), Does.Match(Blend(0)).Or.Match(Blend(14)));
        Assert.That(run.Output, Does.Contain("use this").And.Contain("second half").And.Contain(RecommendTexts.Condition(50, 100)));
    }

    [Test]
    public async Task Recommend_Session_UsesTheTimingOfTheSession()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        VirtualRecording.To(path, seconds: 30);

        var result = await JsonOf(path);

        var condition = result.GetProperty("conditions").EnumerateArray().Single();
        Assert.That(condition.GetProperty("sampling_ms").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(result.GetProperty("interval_ms").GetProperty("median").GetDouble(), Is.EqualTo(50).Within(0.1));
        Assert.That(Candidate(condition, "quadratic").GetProperty("reduction").GetDouble(), Is.GreaterThan(0.6));
        Assert.That(Candidate(condition, "quadratic").GetProperty("halves")[0].GetProperty("frames").GetInt32(), Is.GreaterThan(500));
    }

    [Test]
    public async Task Recommend_SessionWithMissingLines_WarnsOfThem()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        VirtualRecording.To(path, seconds: 30);
        await File.AppendAllTextAsync(path, "{\"kind\":\"lost\",\"count\":12}\n");

        var result = await JsonOf(path);

        Assert.That(result.GetProperty("warnings").Deserialize<string[]>(), Is.EqualTo(new[] { SessionFileMessages.LinesLost(12) }));
    }

    [Test]
    public async Task Recommend_SessionWithoutItsEnd_WarnsOfIt()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        VirtualRecording.To(path, seconds: 30);
        var lines = await File.ReadAllLinesAsync(path);
        await File.WriteAllLinesAsync(path, lines[..^1]);

        var result = await JsonOf(path);

        Assert.That(result.GetProperty("warnings").Deserialize<string[]>(), Is.EqualTo(new[] { SessionFileMessages.NoEnd(EndOf(path)) }));
    }

    static ControlTime EndOf(string path) => RecordedSession.Read(path).Events[^1].At;

    [TestCase(48, true)]
    [TestCase(52, false)]
    public void WarningsOf_SomeRunsMissing_ReportsTheInterruption(int done, bool warns) =>
        Assert.That(RecommendVerb.WarningsOf(session: null, done, all: 52), Is.EqualTo(warns ? new[] { RecommendMessages.Interrupted(48, 52) } : []));

    [Test]
    public async Task Recommend_UnsuitableRecording_PrintsANote()
    {
        using var file = new TemporaryFile("t,a\n0,1\n10,1\n20,1\n");

        var run = await Run(file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Contain("note: " + RecommendMessages.NoMotion(0)).And.Contain("Use predictor " + Predictors.Default));
    }

    static readonly string[][] Unusable =
    [
        ["t,a\n0,1\n0.3,2\n", RecommendMessages.TooShort("")],
        ["t,a\n0,1\n0.1,2\n0.2,1\n0.3,2\n0.4,2\n", RecommendMessages.TooShort("")],
        ["t,a\n0,1\n0.1,2\n0.2,1\n", ReplayMessages.TooShort(0.2, 4 * 0.05 + 0.1 + 1 / 60.0)],
        ["t,a\n0,1\n0,2\n", ":3: " + MotionFileMessages.TimeOrder("t", "'0'")],
    ];

    [TestCaseSource(nameof(Unusable))]
    public async Task Recommend_UnusableFile_PrintsOneLineAndExitsWith2(string text, string expected)
    {
        using var file = new TemporaryFile(text);

        var run = await Run(file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(file.Path).And.Contain(expected));
        Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
    }

    [TestCase("--grid", "--sampling-ms=20")]
    public async Task Recommend_ConflictingOptions_Fails(params string[] options)
    {
        using var file = new TemporaryFile(Motion(Math.Sin));

        var run = await Run([file.Path, .. options]);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("--sampling-ms"));
    }
}
