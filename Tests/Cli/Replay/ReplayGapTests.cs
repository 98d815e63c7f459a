using System.Text.Json;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

/// <summary>Tests the replay of a motion whose recording was interrupted.</summary>
public class ReplayGapTests
{
    const double GapStart = 10, GapEnd = 13;

    string _folder;

    [SetUp]
    public void CreateFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-replay-").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, recursive: true);

    string Motion(string header, Func<double, string> row, double gapEnd = GapEnd)
    {
        var path = Path.Combine(_folder, "motion.csv");
        var times = Enumerable.Range(0, 2301).Select(i => i / 100.0).Where(t => t <= GapStart || t >= gapEnd);
        File.WriteAllLines(path, [header, .. times.Select(t => FormattableString.Invariant($"{t},") + row(t))]);
        return path;
    }

    static string Swing(double t) => FormattableString.Invariant($"{Math.Sin(2 * t)}");

    static string Shift(double t) => FormattableString.Invariant($"{Math.Sin(2 * t)},0,0,0,0,0,1");

    [TestCase("t,a")]
    [TestCase("t_s,x,y,z,qx,qy,qz,qw")]
    public async Task Replay_RecordingWithAGap_ScoresNoFrameInItAndWarns(string header)
    {
        var path = Motion(header, header == "t,a" ? Swing : Shift);

        var run = await CliRun.OfAsync("replay", path, "--predictor", "quadratic", "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        // Scoring starts after 0.3 s. No frame counts from the start of the gap until the first sample after it has arrived.
        var expected = 60 * (23 - 0.3) + 1 - 60 * (GapEnd + 0.1 - GapStart) + 1;
        Assert.That(json.RootElement.GetProperty("frames").GetInt32(), Is.EqualTo(expected).Within(1));
        Assert.That(run.Complaints, Has.Length.EqualTo(1).And.Some.Contain(ReplayMessages.Gaps(1, GapEnd - GapStart)));
    }

    [Test]
    public async Task Replay_Gap_ErrorIsThatOfTheMotionWithoutIt()
    {
        var gap = await RmsOf(Motion("t,a", Swing), "hold");
        var whole = await RmsOf(Motion("t,a", Swing, gapEnd: GapStart), "hold");

        Assert.That(gap, Is.EqualTo(whole).Within(0.02 * whole), "without compensation, a straight line has another error");
    }

    static async Task<double> RmsOf(string path, string predictor)
    {
        var run = await CliRun.OfAsync("replay", path, "--predictor", predictor, "--json");
        using var json = JsonDocument.Parse(run.Output);
        return json.RootElement.GetProperty("rms").GetDouble();
    }
}
