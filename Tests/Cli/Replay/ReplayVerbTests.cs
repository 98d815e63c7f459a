using System.Text.Json;
using Nowpose.Cli;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.Messages;
using Nowpose.Headless.Tests.Cli;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

public class ReplayVerbTests
{
    string _folder;
    string _file;

    [SetUp]
    public void WriteRecording()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;
        _file = new MotionFile(10, MotionFile.EvenTimes(4, 0.01m), Math.Sin, t => Math.Cos(2 * t)).WriteTo(_folder);
    }

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    static Task<CliRun> Run(params string[] arguments) => CliRun.OfAsync(["replay", .. arguments]);

    async Task<JsonElement> RunJson(params string[] arguments)
    {
        var run = await Run([_file, "--json", .. arguments]);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return json.RootElement.Clone();
    }

    static string[] Keys(JsonElement element) => [.. element.EnumerateObject().Select(property => property.Name)];

    [Test]
    public async Task Print_InterruptedReplay_NotesIt([Values] bool isJson, [Values] bool isBody)
    {
        var (_, output, _) = await CapturedConsole.OfAsync(() =>
        {
            if (isBody) ReplayVerb.Print(new BodyReplayResult("f.csv", "hold", 1, default, default), isJson, isInterrupted: true);
            else ReplayVerb.Print(new ReplayResult("f.csv", "hold", 1, []), isJson, isInterrupted: true);
            return Task.FromResult(0);
        });

        var notes = isJson ? JsonDocument.Parse(output).RootElement.GetProperty("notes").Deserialize<string[]>() : [output.ReplaceLineEndings(" ")];
        Assert.That(notes, Has.Exactly(1).Contains(ReplayMessages.Interrupted));
    }

    [Test]
    public async Task Replay_MotionAsJson_HasTheDocumentedKeys()
    {
        var result = await RunJson();

        Assert.That(Keys(result), Is.EqualTo(new[] { "file", "predictor", "frames", "axes", "rms_hold", "rms", "reduction", "conditions" }));
        Assert.That(Keys(result.GetProperty("axes")[1]), Is.EqualTo(new[] { "name", "rms_hold", "rms", "p95", "max" }));
        Assert.That(result.GetProperty("axes").EnumerateArray().Select(axis => axis.GetProperty("name").GetString()),
            Is.EqualTo(new[] { "q1", "q2" }));
        Assert.That(result.GetProperty("file").GetString(), Is.EqualTo(_file));
        Assert.That(result.GetProperty("predictor").GetString(), Is.EqualTo("adaptive"));
        Assert.That(result.GetProperty("reduction").GetDouble(), Is.GreaterThan(0.9));
    }

    [Test]
    public async Task Replay_MotionAsJson_StatesTheConditions()
    {
        var conditions = (await RunJson("--phases", "4", "--latency-ms", "90", "--stamp-error-ms", "2", "--seed", "7")).GetProperty("conditions");

        Assert.That(Keys(conditions), Is.EqualTo(new[]
        {
            "version", "predictor", "sampling_ms", "latency_ms", "fps", "phases", "latency_error_ms", "stamp_error_ms", "jitter_ms", "loss", "blend_ms", "seed",
        }));
        Assert.That(
            new[] { "phases", "latency_ms", "stamp_error_ms", "seed", "fps" }.Select(key => conditions.GetProperty(key).GetDouble()),
            Is.EqualTo(new[] { 4, 90, 2, 7, 60 }));
        Assert.That(conditions.GetProperty("version").GetString(), Is.EqualTo(ProgramVersion.Text));
    }

    [Test]
    public async Task Replay_Phases_ResultIsThatOfAllPasses()
    {
        var result = await RunJson("--phases", "5", "--predictor", "linear");

        var phases = result.GetProperty("passes").EnumerateArray().Select(pass => pass.GetProperty("rms").GetDouble()).ToList();
        Assert.That(phases, Has.Count.EqualTo(5).And.Unique);
        Assert.That(phases[0], Is.EqualTo((await RunJson("--predictor", "linear")).GetProperty("rms").GetDouble()).Within(1e-12), "the first phase is that of the default");
        Assert.That(result.GetProperty("rms").GetDouble(), Is.InRange(phases.Min(), phases.Max()));
    }

    [Test]
    public async Task Replay_RobotAtRest_HasNullReduction()
    {
        File.WriteAllText(_file, "t,a\n0,1\n2,1\n");

        Assert.That((await RunJson()).GetProperty("reduction").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    // Each option alone must change one result in the expected direction.
    [TestCase("--sampling-ms=100", "rms", 1)]
    [TestCase("--latency-ms=200", "rms_hold", 1)]
    [TestCase("--latency-ms=50", "rms_hold", -1)]
    [TestCase("--fps=120", "frames", 1)]
    [TestCase("--predictor=linear", "rms", 1)]
    [TestCase("--latency-error-ms=20", "rms", 1)]
    [TestCase("--stamp-error-ms=5", "rms", 1)]
    [TestCase("--jitter-ms=40", "rms_hold", 1)]
    [TestCase("--loss=0.3", "rms_hold", 1)]
    [TestCase("--blend-ms=50", "rms", 1)]
    public async Task Replay_Option_IsApplied(string option, string key, int sign)
    {
        var plain = (await RunJson()).GetProperty(key).GetDouble();

        var joined = (await RunJson(option)).GetProperty(key).GetDouble();
        var apart = (await RunJson(option.Split('='))).GetProperty(key).GetDouble();

        Assert.That(sign * (joined - plain), Is.GreaterThan(0.01 * plain));
        Assert.That(apart, Is.EqualTo(joined));
    }

    [Test]
    public async Task Replay_SeedOption_ChangesOnlyRandomConditions()
    {
        var jittered = (await RunJson("--jitter-ms", "40", "--seed", "1")).GetProperty("rms").GetDouble();

        Assert.That((await RunJson("--jitter-ms", "40", "--seed", "2")).GetProperty("rms").GetDouble(), Is.Not.EqualTo(jittered));
        Assert.That((await RunJson("--seed", "2")).GetProperty("rms").GetDouble(),
            Is.EqualTo((await RunJson()).GetProperty("rms").GetDouble()));
    }

    [Test]
    public async Task Replay_Motion_PrintsEveryAxisToStdout()
    {
        var run = await Run(_file);

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Errors, Is.Empty);
        Assert.That(run.Output, Does.Contain("q1").And.Contain("q2")
            .And.Contain("uncompensated RMS").And.Contain("motion.csv: adaptive"));
    }

    // A motion with one row every 10 ms, whose time stamps are in the given unit.
    string Stamped(int rows, double perSecond, string header, Func<double, string> positions)
    {
        File.WriteAllLines(_file, [header, .. Enumerable.Range(0, rows).Select(i =>
            FormattableString.Invariant($"{0.01 * perSecond * i},") + positions(0.01 * i))]);
        return _file;
    }

    static string Swing(double t) => FormattableString.Invariant($"{Math.Sin(t)}");

    static string Shift(double t) => FormattableString.Invariant($"{Math.Sin(t)},0,0,0,0,0,1");

    [TestCase("t,a")]
    [TestCase("t_s,x,y,z,qx,qy,qz,qw")]
    public async Task Replay_TimeStampsInMilliseconds_WarnsThatSamplesAreInterpolated(string header)
    {
        // Each second of this motion is replayed as 1000 s.
        var run = await Run(Stamped(201, 1000, header, header == "t,a" ? Swing : Shift), "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Complaints, Is.EqualTo(new[] { ConsoleMessages.Line($"{_file}: {ReplayMessages.CoarseRows(10_000, 50)}") }));
        using var json = JsonDocument.Parse(run.Output);
        Assert.That(json.RootElement.GetProperty("notes").Deserialize<string[]>(), Is.EqualTo(new[] { ReplayMessages.CoarseRows(10_000, 50) }));
    }

    [TestCase("9.5", true)]
    [TestCase("10", false)]
    [TestCase("50", false)]
    public async Task Replay_RowsAboutAsOftenAsSamples_WarnsOnlyIfTheyAreCoarser(string samplingMs, bool warns)
    {
        var run = await Run(Stamped(2001, 1.06, "t,a", Swing), "--sampling-ms", samplingMs);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Complaints.Length, Is.EqualTo(warns ? 1 : 0), run.Errors);
    }

    [TestCase("--sampling-ms", "0", "0.1 to 10000 ms")]
    [TestCase("--sampling-ms", "-5", "0.1 to 10000 ms")]
    [TestCase("--sampling-ms", "NaN", "0.1 to 10000 ms")]
    [TestCase("--sampling-ms", "fast", "0.1 to 10000 ms")]
    [TestCase("--sampling-ms", "5,5", "0.1 to 10000 ms")]
    [TestCase("--latency-ms", "-1", "0 to 10000 ms")]
    [TestCase("--latency-ms", "Infinity", "0 to 10000 ms")]
    [TestCase("--fps", "0", "1 to 1000")]
    [TestCase("--fps", "1e9", "1 to 1000")]
    [TestCase("--latency-error-ms", "1e5", "-10000 to 10000 ms")]
    [TestCase("--stamp-error-ms", "-1", "0 to 10000 ms")]
    [TestCase("--jitter-ms", "-1", "0 to 10000 ms")]
    [TestCase("--loss", "1.1", "0 to 1")]
    [TestCase("--loss", "-0.1", "0 to 1")]
    [TestCase("--phases", "0", "1 to 1000")]
    [TestCase("--seed", "1.5", "")]
    [TestCase("--predictor", "quartic", "hold, linear, quadratic, cubic")]
    [TestCase("--window", "3", "--window")]
    public async Task Replay_InvalidOption_PrintsOneLineAndExitsWith2(string option, string value, string allowed)
    {
        var run = await Run(_file, option, value);

        AssertRefused(run, option, allowed);
    }

    [TestCase("--fps")]
    [TestCase("--sampling-ms")]
    [TestCase("--predictor")]
    public async Task Replay_OptionWithoutValue_PrintsOneLineAndExitsWith2(string option)
    {
        var run = await Run(_file, option);

        AssertRefused(run, option);
    }

    [Test]
    public async Task Replay_MorePhasesThanFit_NamesTheOptionAndTheMaximum()
    {
        File.WriteAllText(_file, "t,a\n0,0\n100000,1\n");

        AssertRefused(await Run(_file, "--phases", "9"), ReplayMessages.TooManyPhases(_file, 9, 100_000, 8));
    }

    [Test]
    public async Task Replay_NoFile_PrintsOneLineAndExitsWith2()
    {
        var run = await Run();

        AssertRefused(run, "'FILE'");
    }

    [Test]
    public async Task Replay_FileMissing_PrintsOneLineAndExitsWith2()
    {
        var run = await Run(Path.Combine(_folder, "none.csv"));

        AssertRefused(run, PathMessages.NotFound(Path.Combine(_folder, "none.csv")));
    }

    static readonly string[][] InvalidFiles =
    [
        ["t,a\n0,1\n1,\n", "motion.csv:3: " + MotionFileMessages.EmptyField("'a'")],
        ["t,a\n0,1\n1,x\n", "motion.csv:3: " + MotionFileMessages.NotANumber("'a'", "'x'")],
        ["t,a\n1,1\n0,1\n", "motion.csv:3: " + MotionFileMessages.TimeOrder("t", "'0'")],
        ["t,a\n1,1\n", MotionFileMessages.TooFewRows("motion.csv", 1)],
        ["t,a\n0,1\n0.2,2\n", ReplayMessages.TooShort(0.2, 4 * 0.05 + 0.1 + 1 / 60.0)],
    ];

    [TestCaseSource(nameof(InvalidFiles))]
    public async Task Replay_InvalidFile_PrintsOneLineAndExitsWith2(string content, string expected)
    {
        File.WriteAllText(_file, content);

        var run = await Run(_file);

        AssertRefused(run, expected);
    }

    [Test]
    public async Task Replay_AllSamplesLost_PrintsOneLineAndExitsWith2()
    {
        var run = await Run(_file, "--loss", "1");

        AssertRefused(run, ReplayMessages.AllLost(1));
    }

    static void AssertRefused(CliRun run, params string[] expected)
    {
        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), run.Errors);
        foreach (var text in expected) Assert.That(run.Errors, Does.Contain(text));
    }
}
