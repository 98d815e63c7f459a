using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests that the demo runs over real sockets in real time, and that it writes its files.</summary>
/// <remarks>Tests of the virtual robot cell and of planned sessions measure the reduction of the error, in virtual time.</remarks>
public class DemoVerbTests
{
    string _folder;

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-demo-").FullName;

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, recursive: true);

    JsonElement Result() => JsonDocument.Parse(File.ReadAllText(Path.Combine(_folder, "result.json"))).RootElement;

    // Over Wi-Fi, the clock may still be coarse after 5 s on a busy machine.
    [Test]
    public async Task Demo_FiveSeconds_WritesItsFilesWithTheExpectedFields()
    {
        var run = await CliRun.OfAsync("demo", "--seconds", "5", "--network", "lan", "--predictor", "quadratic", "--visu-error-ms", "3", "--out", _folder);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Contain("report.html").And.Contain("uncompensated"));
        Assert.That(run.Errors, Does.Contain("of 5 s"), "progress");
        AssertFields(Result());
        var report = File.ReadAllText(Path.Combine(_folder, "report.html"));
        Assert.That(report, Does.Contain("Nowpose demo: youbot"));
        if (Nowpose.Web.ReportPage.HasPlots) AssertPlayback(report);
        await AssertReplayable();
    }

    static void AssertFields(JsonElement result)
    {
        Assert.That(result.GetProperty("tool_error_mm").GetProperty("hold_rms").GetDouble(), Is.GreaterThan(5));
        Assert.That(result.GetProperty("latency_ms").GetProperty("app_p50").GetDouble(), Is.GreaterThan(50));
        Assert.That(result.GetProperty("frames").GetInt32(), Is.EqualTo(300));
        Assert.That(result.GetProperty("network").GetString(), Is.EqualTo("lan"));
        Assert.That(Names(result), Is.EqualTo("seconds frames samples dropped network latency_ms clock tool_error_mm frame hindcast range light_error_ms bodies"));
        Assert.That(result.GetProperty("range").ValueKind, Is.EqualTo(JsonValueKind.Null), "no load");
        Assert.That(Names(result.GetProperty("latency_ms")), Is.EqualTo("app_p50 app_p95 visu total_error_p95"));
        Assert.That(
            Names(result.GetProperty("clock")),
            Is.EqualTo("offset_error_us_p50 offset_error_us_p95 offset_error_us_max skew_error_ppm converged_s"));
        Assert.That(
            Names(result.GetProperty("tool_error_mm")),
            Is.EqualTo("hold_rms hold_max rms p95 max reduction reduction_first_cycle reduction_repeated"));
        Assert.That(Names(result.GetProperty("frame")), Is.EqualTo("cpu_us_p50 cpu_us_p99 allocated_bytes_per_frame"));
        Assert.That(Names(result.GetProperty("light_error_ms")), Is.EqualTo("p50 p95 max"));
        Assert.That(Names(result.GetProperty("bodies")), Is.EqualTo("error_mm error_deg largest_slip_mm"));
        foreach (var kind in new[] { "error_mm", "error_deg" })
            Assert.That(Names(result.GetProperty("bodies").GetProperty(kind)), Is.EqualTo("hold_rms rms p95 reduction"));
        Assert.That(Names(result.GetProperty("hindcast")), Is.EqualTo("reduction reduction_uncertainty rms_mm hold_rms_mm withheld"));
        var repeated = result.GetProperty("tool_error_mm").GetProperty("reduction_repeated");
        Assert.That(repeated.ValueKind, Is.EqualTo(JsonValueKind.Null), "five seconds contain no third cycle");
    }

    async Task AssertReplayable()
    {
        var session = Path.Combine(_folder, "session.jsonl");
        var replay = await CliRun.OfAsync("replay", session, "--json");
        var sync = await CliRun.OfAsync("sync", session);

        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
        Assert.That(JsonDocument.Parse(replay.Output).RootElement.GetProperty("frames").GetInt32(), Is.GreaterThan(0));
        Assert.That(sync.Lines, Has.Length.GreaterThan(20));
        Assert.That(File.ReadLines(session).Last(), Does.Contain("\"closed\""));
    }

    [Test]
    public async Task Demo_Trajectory_IsShownRecordedAndReplayed()
    {
        var run = await CliRun.OfAsync("demo", "--trajectory", "--seconds", "5", "--network", "lan", "--out", _folder);
        var session = Path.Combine(_folder, "session.jsonl");
        var replay = await CliRun.OfAsync("replay", session, "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(Result().GetProperty("dropped").GetInt32(), Is.EqualTo(0));
        var plans = File.ReadLines(session).Count(line => line.StartsWith("{\"kind\":\"plan\"", StringComparison.Ordinal));
        Assert.That(plans, Is.InRange(1, 22), "four a second at most");
        Assert.That(replay.ExitStatus, Is.EqualTo(0), replay.Errors);
    }

    [Test]
    public async Task Demo_RecordingOfAnotherRobot_PlaysItsColumns()
    {
        // The motion starts and ends at rest, because the demo plays it alternately forward and backward.
        var rows = Enumerable.Range(0, 301)
            .Select(i => (Time: i * 0.02, Swing: Math.Cos(i * Math.PI / 150)))
            .Select(row => FormattableString.Invariant($"{row.Time},{-row.Swing},{-1 + 0.3 * row.Swing}"));
        using var recording = new TemporaryFile("t,q1,q2\n" + string.Join('\n', rows) + "\n", ".csv.gz");

        var run = await CliRun.OfAsync(
            "demo", "--seconds", "5", "--network", "lan", "--robot", "ur5", "--recording", recording.Path, "--out", _folder);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(Result().GetProperty("tool_error_mm").GetProperty("hold_rms").GetDouble(), Is.GreaterThan(1));
    }

    [Test]
    [Platform(Exclude = "Win", Reason = "no program sends another one Ctrl-C there")]
    public async Task Demo_Interrupted_WritesItsMeasurementsAndExitsWith130()
    {
        using var run = new PeerProcess("Nowpose.Cli.dll", "demo", "--network", "lan", "--out", _folder);
        await Soon.BecomesAsync(() => run.Printed("3 of 20 s"), "three seconds of the run");

        var status = await run.InterruptAsync();

        Assert.That(status, Is.EqualTo(130));
        Assert.That(Result().GetProperty("seconds").GetDouble(), Is.GreaterThan(0).And.LessThan(20));
        Assert.That(File.Exists(Path.Combine(_folder, "report.html")), Is.True);
    }

    [TestCase("--seconds", "1", "--seconds: 1 s is out of range; allowed: 5 to 3600 s")]
    [TestCase("--seconds", "soon", "--seconds: 'soon' is not a number")]
    [TestCase("--seed", "1.5", "--seed: '1.5' is not a whole number; allowed: 0 to 1000000")]
    [TestCase("--seed", "99999999999", "--seed: 99999999999 is out of range")]
    [TestCase("--load", "2000001", "--load: 2000001 vertices is out of range; allowed: 0 to 2000000 vertices")]
    [TestCase("--network", "carrier-pigeon", "--network: 'carrier-pigeon' is unknown; allowed: lan, wifi, busy-wifi")]
    [TestCase("--acquisition-ms", "105-55", "--acquisition-ms: '105-55' is not a range; allowed: MIN-MAX with 0 <= MIN <= MAX <= 1000 ms")]
    [TestCase("--acquisition-ms", "5-x", "--acquisition-ms: '5-x' is not a range")]
    [TestCase("--predictor", "crystal-ball", "--predictor: 'crystal-ball' is unknown")]
    [TestCase("--robot", "r2d2", "r2d2")]
    [TestCase("--recording", "gone.csv", "gone.csv: file not found")]
    [TestCase("--visu-error-ms", "-50", "--visu-ms plus --visu-error-ms: -10 ms is out of range")]
    [TestCase("--out", "/dev/null/x", "--out: /dev/null/x: cannot be written")]
    public async Task Demo_InvalidOption_PrintsOneLineAndExitsWith2(string option, string value, string named)
    {
        var before = Directory.Exists("nowpose-demo");

        var run = await CliRun.OfAsync("demo", option, value);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(Directory.Exists("nowpose-demo"), Is.EqualTo(before), "nothing is left behind");
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(named));
    }

    static string Names(JsonElement element) => string.Join(' ', element.EnumerateObject().Select(property => property.Name));

    // Checks that the playback on the page starts at the same time as the error plot, and that its tracks have a value for each joint.
    static void AssertPlayback(string report)
    {
        var json = Regex.Match(report, "id=\"report-data\">(.*?)</script>", RegexOptions.Singleline).Groups[1].Value;
        var page = JsonDocument.Parse(json).RootElement;
        var playback = page.GetProperty("playback");
        double FirstOf(string part) => page.GetProperty(part).GetProperty("t")[0].GetDouble();
        double[][] Track(string name) => playback.GetProperty(name).Deserialize<double[][]>();
        var (truth, displayed, hold) = (Track("truth"), Track("displayed"), Track("hold"));
        var names = playback.GetProperty("names").GetArrayLength();

        Assert.That(playback.GetProperty("urdf").GetString(), Does.Contain("<robot"));
        Assert.That(FirstOf("playback"), Is.EqualTo(FirstOf("error")).Within(0.001), "playback and plots begin at the same time");
        Assert.That(playback.GetProperty("t").GetArrayLength(), Is.EqualTo(truth.Length).And.GreaterThan(0));
        Assert.That(truth.Concat(displayed).Concat(hold), Has.All.Length.EqualTo(names));
    }
}
