using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Plants;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the exit status, the files and the text of runs in virtual time.</summary>
public class DemoFilesTests
{
    TemporaryFolder _folder;

    [SetUp]
    public void MakeFolder() => _folder = new TemporaryFolder();

    [TearDown]
    public void RemoveFolder() => _folder.Dispose();

    static DemoRun Play(double seconds) => VirtualStage.Play(
        VirtualDemo.Settings(seconds, "lan", 1, "quadratic") with { VisualisationErrorMs = 3 }, hasScene: false);

    Task<(int Status, string Output, string Errors)> FinishAsync(DemoRun run, bool isInterrupted = false) => CapturedConsole.OfAsync(() =>
    {
        using var output = DemoOutput.At(_folder.Path, isPaper: false);
        return Task.FromResult(DemoVerb.Finish(run, output, isInterrupted));
    });

    string Written(string file) => File.ReadAllText(Path.Combine(_folder.Path, file));

    [Test]
    public async Task Finish_CompleteRun_WritesItsFilesWithTheExpectedFields()
    {
        var (status, output, _) = await FinishAsync(Play(5));

        Assert.That(status, Is.EqualTo(0));
        Assert.That(output, Does.Contain("report.html").And.Contain("uncompensated"));
        AssertFields(JsonDocument.Parse(Written("result.json")).RootElement);
        Assert.That(Written("report.html"), Does.Contain(DemoTexts.ReportTitle("youbot")));
        if (Nowpose.Web.Pages.Report.HasPlots) AssertPlayback(Written("report.html"));
    }

    [TestCase(false)]
    [TestCase(true)]
    public async Task Finish_ClockNeverSynchronised_FailsUnlessInterrupted(bool isInterrupted)
    {
        var run = Play(0.5);
        Assert.That(run.Frames.Rows.Select(row => row.Clock.State), Has.None.EqualTo(ClockState.Synchronised), "precondition");

        if (!isInterrupted) Assert.That(() => FinishAsync(run), Throws.TypeOf<DemoFailedException>());
        else Assert.That((await FinishAsync(run, isInterrupted)).Status, Is.EqualTo(130));

        Assert.That(File.Exists(Path.Combine(_folder.Path, "result.json")), Is.EqualTo(isInterrupted));
    }

    [Test]
    public async Task Finish_Interrupted_MarksResultReportAndTable()
    {
        var run = Play(5);

        var (_, output, _) = await FinishAsync(run with { Settings = run.Settings with { Seconds = 20 } }, isInterrupted: true);

        AssertNotes(output, DemoMessages.Interrupted(5, 20));
    }

    [Test]
    public async Task Finish_MotionInDegrees_NotesTheLimits()
    {
        using var file = new TemporaryFile("t,a\n0,100\n100,200\n");
        var settings = VirtualDemo.Settings(5, "lan", 1, "quadratic");
        var run = VirtualStage.Play(
            settings with { Motion = new CellMotion(new RecordedMotion(MotionRecording.Read(file.Path), settings.Robot)) }, hasScene: false);

        var (status, output, _) = await FinishAsync(run);

        Assert.That(status, Is.EqualTo(0));
        Assert.That(run.BeyondLimits, Has.Count.EqualTo(1));
        AssertNotes(output, run.BeyondLimits[0].Words);
    }

    [TestCase("recording session.jsonl has stopped", 0)]
    [TestCase(null, 3)]
    public async Task Finish_IncompleteRecording_NotesIt(string problem, int lost)
    {
        var (_, output, _) = await FinishAsync(Play(5) with { RecordingProblem = problem, LostLines = lost });

        AssertNotes(output, problem ?? DemoMessages.LinesLost(lost));
    }

    [Test]
    public async Task Finish_LateFrames_NotesAndCountsThem()
    {
        var run = Play(5);
        for (var i = 200; i < 210; i++) run.Frames.Rows[i] = run.Frames.Rows[i] with { Delay = TimeSpan.FromMilliseconds(30 + i - 200) };

        var (_, output, _) = await FinishAsync(run);

        AssertNotes(output, DemoMessages.LateFrames(new LateFrames(10, 120, 39)));
        var result = JsonDocument.Parse(Written("result.json")).RootElement;
        Assert.That((result.GetProperty("frames_late").GetInt32(), result.GetProperty("frames_scored").GetInt32()), Is.EqualTo((10, 120)));
    }

    [Test]
    public async Task Settings_RecordingInMilliseconds_HaveAWarningThatIsWritten()
    {
        using var file = new TemporaryFile("t,a\n0,0\n10,1\n20,0\n");

        var settings = DemoVerb.Settings(DemoVerb.Create().Parse(["--recording", file.Path]));

        Assert.That(
            settings.MotionWarnings,
            Is.EqualTo(new[] { ReplayMessages.CoarseRows(10_000, 50), PlantMessages.ColumnsInOrder(file.Path, "youbot", "a moves arm_joint_1") }));
        foreach (var warning in settings.MotionWarnings)
        {
            var run = Play(5);
            var (_, output, _) = await FinishAsync(run with { Settings = run.Settings with { MotionWarnings = [warning] } });
            AssertNotes(output, warning);
        }
    }

    void AssertNotes(string output, string note)
    {
        var notes = JsonDocument.Parse(Written("result.json")).RootElement.GetProperty("notes").Deserialize<string[]>();
        Assert.That(notes, Is.EqualTo(new[] { note }));
        // The console breaks the sentence at the end of a line.
        static string Unbroken(string text) => string.Concat(text.Where(c => !char.IsWhiteSpace(c)));
        Assert.That(Unbroken(output), Does.Contain(Unbroken(DemoTexts.Note(note))));
        Assert.That(Written("report.html"), Does.Contain(DemoTexts.Note(note).Split('\'')[0]));
    }

    static void AssertFields(JsonElement result)
    {
        Assert.That(result.GetProperty("tool_error_mm").GetProperty("hold_rms").GetDouble(), Is.GreaterThan(5));
        Assert.That(result.GetProperty("latency_ms").GetProperty("app_p50").GetDouble(), Is.GreaterThan(50));
        Assert.That(result.GetProperty("frames").GetInt32(), Is.EqualTo(300));
        Assert.That(result.GetProperty("network").GetString(), Is.EqualTo("lan"));
        Assert.That(Names(result), Is.EqualTo("seconds frames samples dropped network latency_ms clock tool_error_mm frame hindcast range light_error_ms "
            + "bodies frames_scored frames_late conditions"));
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
