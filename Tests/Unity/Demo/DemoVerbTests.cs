using System.Text.Json;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Gateway.Messages;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests that the demo runs over real sockets in real time, and that it records its session.</summary>
/// <remarks>
/// These tests do not depend on the number of samples or on the clock, which may still be coarse on a busy machine. <see cref="DemoFilesTests"/> tests
/// the results in virtual time.
/// </remarks>
public class DemoVerbTests
{
    // Longer than any wait, so that each run ends because the test interrupts it.
    const string Long = "3600";

    TemporaryFolder _folder;

    [SetUp]
    public void MakeFolder() => _folder = new TemporaryFolder();

    [TearDown]
    public void RemoveFolder() => _folder.Dispose();

    string Session => Path.Combine(_folder.Path, "session.jsonl");

    [Test]
    public async Task PlayAsync_OneSecond_ShowsEachFrameAndRecordsIt()
    {
        var run = await DemoStage.PlayAsync(VirtualDemo.Settings(1, "lan", 1), Session, CancellationToken.None).Bounded();

        Assert.That(run.Frames.Rows, Has.Count.EqualTo(60));
        Assert.That(run.Frames.Rows.Select(row => row.Elapsed), Is.Ordered);
        Assert.That(RecordedSession.Read(Session).Frames, Is.EqualTo(60));
    }

    [Test]
    [Platform(Exclude = "Win", Reason = "no program sends another one Ctrl-C there")]
    public async Task Demo_Interrupted_WritesItsMeasurementsAndExitsWith130()
    {
        using var run = Start("--trajectory");
        await RecordsAsync(run, "plan", 2);
        await RecordsAsync(run, "sync", 20);
        await RecordsAsync(run, "sample", 20);
        await run.PrintsAsync("of 3600 s: clock ");

        var status = await run.InterruptAsync();

        Assert.That(status, Is.EqualTo(130), run.All);
        var result = JsonDocument.Parse(File.ReadAllText(Path.Combine(_folder.Path, "result.json"))).RootElement;
        Assert.That(result.GetProperty("seconds").GetDouble(), Is.GreaterThan(0).And.LessThan(3600));
        Assert.That(File.Exists(Path.Combine(_folder.Path, "report.html")), Is.True);
        Assert.That(File.ReadLines(Session).Last(), Does.Contain("\"closed\""));
        Assert.That(
            RecordedSession.Read(Session).Events.Select(one => one.Kind).Distinct(),
            Is.SupersetOf(new[] { RecordedSession.EventKind.Sample, RecordedSession.EventKind.Plan, RecordedSession.EventKind.Frame }));
        var exchanges = await CliRun.OfAsync("sync", Session);
        Assert.That(exchanges.Lines, Has.Length.EqualTo(1 + Recorded("sync").Count), "a header, and a line for each exchange");
    }

    [Test]
    [Platform(Exclude = "Win", Reason = "no program sends another one Ctrl-C there")]
    public async Task Demo_RecordingOfAnotherRobot_PlaysItsColumns()
    {
        // The motion starts and ends at rest, because the demo plays it alternately forward and backward.
        var rows = Enumerable.Range(0, 301)
            .Select(i => (Time: i * 0.02, Swing: Math.Cos(i * Math.PI / 150)))
            .Select(row => FormattableString.Invariant($"{row.Time},{-row.Swing},{-1 + 0.3 * row.Swing}"));
        using var recording = new TemporaryFile("t,q1,q2\n" + string.Join('\n', rows) + "\n", ".csv.gz");
        using var run = Start("--robot", "ur5", "--recording", recording.Path);

        await RecordsAsync(run, "sample", 20);

        var positions = Recorded("sample").Select(sample => sample.GetProperty("position").Deserialize<double[]>()).ToList();
        Assert.That(positions.Max(sample => sample[0]) - positions.Min(sample => sample[0]), Is.GreaterThan(0.01), "the robot moves");
        Assert.That(positions.Select(sample => sample[1] + 1 + 0.3 * sample[0]), Is.All.EqualTo(0).Within(1e-9), "the second column follows the first");
        Assert.That(positions.SelectMany(sample => sample.Skip(2)), Has.Exactly(4 * positions.Count).EqualTo(0), "joints without a column rest");
    }

    PeerProcess Start(params string[] options) =>
        new("Nowpose.Cli.dll", ["demo", "--seconds", Long, "--network", "lan", "--out", _folder.Path, .. options]);

    Task RecordsAsync(PeerProcess run, string kind, int count) =>
        Soon.BecomesAsync(() => Recorded(kind).Count >= count, () => $"{count} lines {kind} in the recording; {run.All}", 100);

    /// <summary>Returns the complete lines of a kind that the recording contains so far.</summary>
    List<JsonElement> Recorded(string kind)
    {
        if (!File.Exists(Session)) return [];
        var text = File.ReadAllText(Session);
        return
        [
            .. text[..(text.LastIndexOf('\n') + 1)].Split('\n').Where(line => line.StartsWith($"{{\"kind\":\"{kind}\"", StringComparison.Ordinal))
                .Select(line => JsonDocument.Parse(line).RootElement),
        ];
    }

    static readonly string[][] InvalidOptions =
    [
        ["--seconds", "1", OptionMessages.OutOfRange("--seconds", "1", " s", "allowed: 5 to 3600 s.")],
        ["--seconds", "soon", OptionMessages.NotANumber("--seconds", "soon", "allowed: 5 to 3600 s.")],
        ["--seed", "1.5", OptionMessages.NotWhole("--seed", "1.5", "allowed: 0 to 1000000.")],
        ["--seed", "99999999999", OptionMessages.OutOfRange("--seed", "99999999999", "", "allowed: 0 to 1000000.")],
        ["--load", "2000001", OptionMessages.OutOfRange("--load", "2000001", " vertices", "allowed: 0 to 2000000 vertices.")],
        ["--network", "carrier-pigeon", OptionMessages.UnknownChoice("--network", "carrier-pigeon", "lan, wifi, busy-wifi")],
        ["--acquisition-ms", "105-55", OptionMessages.NotARange("--acquisition-ms", "105-55", 1000)],
        ["--acquisition-ms", "5-x", OptionMessages.NotARange("--acquisition-ms", "5-x", 1000)],
        ["--predictor", "crystal-ball", OptionValueMessages.UnknownPredictor("--predictor", "crystal-ball", string.Join(", ", Predictors.Names))],
        ["--robot", "r2d2", "r2d2"],
        ["--recording", "gone.csv", PathMessages.NotFound("gone.csv")],
        ["--visu-error-ms", "-50", DemoMessages.AssumedVisu(-10)],
        ["--out", ImpossiblePath.BelowAFile("x"), $"--out: {ImpossiblePath.BelowAFile("x")}: cannot be written"],
    ];

    [TestCaseSource(nameof(InvalidOptions))]
    public async Task Demo_InvalidOption_PrintsOneLineAndExitsWith2(string option, string value, string named)
    {
        var before = Directory.Exists("nowpose-demo");

        var run = await CliRun.OfAsync("demo", option, value);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(Directory.Exists("nowpose-demo"), Is.EqualTo(before), "nothing is left behind");
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(named));
    }
}
