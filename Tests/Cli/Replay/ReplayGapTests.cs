using System.Text.Json;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>Tests the replay of a motion with long intervals without rows.</summary>
public class ReplayGapTests
{
    const double GapStart = 10, GapEnd = 13;

    string _folder;

    [SetUp]
    public void CreateFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    // A row every 10 ms for 23 s. Between the ends of the gap, the motion is a straight line.
    string Motion(string header, Func<double, string> row, bool hasRowsInGap = false, double interval = 0.01)
    {
        var path = Path.Combine(_folder, "motion.csv");
        var times = Enumerable.Range(0, (int)(23 / interval) + 1).Select(i => i * interval).Where(t => t <= GapStart || t >= GapEnd || hasRowsInGap);
        File.WriteAllLines(path, [header, .. times.Select(t => FormattableString.Invariant($"{t},") + row(t))]);
        return path;
    }

    static double Line(double t) => t is > GapStart and < GapEnd
        ? (Math.Sin(2 * GapStart) * (GapEnd - t) + Math.Sin(2 * GapEnd) * (t - GapStart)) / (GapEnd - GapStart) : Math.Sin(2 * t);

    static string Swing(double t) => FormattableString.Invariant($"{Line(t)}");

    static string Shift(double t) => FormattableString.Invariant($"{Line(t)},0,0,0,0,0,1");

    static async Task<(JsonElement Result, string[] Warnings)> Replay(string path, string predictor = "quadratic")
    {
        var run = await CliRun.OfAsync("replay", path, "--predictor", predictor, "--json");
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        return (json.RootElement.Clone(), run.Complaints);
    }

    [TestCase("hold")]
    [TestCase("quadratic")]
    [TestCase("adaptive")]
    public async Task Replay_RecordingWithAGap_EqualsTheStraightLineInIt(string predictor)
    {
        var (gap, warnings) = await Replay(Motion("t,a", Swing), predictor);
        var (line, none) = await Replay(Motion("t,a", Swing, hasRowsInGap: true), predictor);

        Assert.That(gap.GetProperty("frames").GetInt32(), Is.EqualTo(line.GetProperty("frames").GetInt32()).And.EqualTo(23 * 60 + 1 - 18));
        Assert.That(gap.GetProperty("rms").GetDouble(), Is.EqualTo(line.GetProperty("rms").GetDouble()).Within(1e-9));
        Assert.That(warnings, Has.Length.EqualTo(1).And.Some.Contain(ReplayMessages.Gaps(new(1, 3))));
        Assert.That(none, Is.Empty);
    }

    [Test]
    public async Task Replay_BodyWithAGap_Warns()
    {
        var (_, warnings) = await Replay(Motion("t_s,x,y,z,qx,qy,qz,qw", Shift));

        Assert.That(warnings, Has.Length.EqualTo(1).And.Some.Contain(ReplayMessages.Gaps(new(1, 3))));
    }

    [Test]
    public async Task Replay_RestWithoutRows_DoesNotWarn()
    {
        var (_, warnings) = await Replay(Motion("t,a", t => FormattableString.Invariant($"{Math.Min(t, GapStart) + Math.Max(0, t - GapEnd)}")));

        Assert.That(warnings, Is.Empty);
    }

    [Test]
    public async Task Replay_FewRows_DoesNotWarnOfAGap()
    {
        var (_, warnings) = await Replay(Motion("t,a", Swing, interval: 0.5));

        Assert.That(warnings, Has.Length.EqualTo(1).And.Some.Contain(ReplayMessages.CoarseRows(500, 50)));
    }

    [Test]
    public async Task Replay_CoarseRowsWithAGap_WarnsOnce()
    {
        var (_, warnings) = await Replay(Motion("t,a", Swing, interval: 0.2));

        Assert.That(warnings, Has.Length.EqualTo(1).And.Some.Contain(ReplayMessages.CoarseRows(200, 50, new(1, 3))));
    }
}
