using System.Text.Json;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Virtual;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the cell's signals in the report of a demo in virtual time.</summary>
public class SignalsInDemoTests
{
    /// <summary>Maximum time from a change to its display, s. It includes acquisition, network and one frame.</summary>
    const double MaxDelay = 0.3;

    static readonly string[] Names = ["gripper_closed", "belt_running", "part_present"];

    static DemoSettings Settings() => VirtualDemo.Settings(20, "wifi", 1, "adaptive");

    static JsonElement PlaybackOf(DemoRun run)
    {
        var score = new DemoScore(run);
        return JsonDocument.Parse(DemoReport.Of(score, run, score.Result())).RootElement.GetProperty("playback");
    }

    static (double T, double? V)[] ChangesOf(JsonElement signal, string track)
    {
        var (times, values) = (signal.GetProperty(track).GetProperty("t"), signal.GetProperty(track).GetProperty("v"));
        return times.Deserialize<double[]>().Zip(values.Deserialize<double?[]>()).ToArray();
    }

    [Test]
    public void Report_Signals_AreDisplayedSoonAfterEachChangeAndNotBefore()
    {
        var playback = PlaybackOf(VirtualStage.Play(Settings(), hasScene: false));

        var signals = playback.GetProperty("signals").EnumerateArray().ToList();
        Assert.That(signals.Select(signal => signal.GetProperty("name").GetString()), Is.EqualTo(Names));
        var times = playback.GetProperty("t").Deserialize<double[]>();
        foreach (var signal in signals)
        {
            var (truth, displayed) = (ChangesOf(signal, "truth"), ChangesOf(signal, "displayed"));
            Assert.That(truth.Length, Is.GreaterThan(2), "the signal changes");
            Assert.That((truth[0].T, displayed[0].T), Is.EqualTo((times[0], times[0])), "signals and poses begin at the same time");
            // The first value is older than the playback, and the last change may be displayed after its end.
            var expected = truth.Skip(1).Where(change => change.T < times[^1] - MaxDelay).ToList();
            var shown = displayed.Skip(1).Where(change => change.T > expected[0].T - 1e-6).Take(expected.Count).ToList();
            Assert.That(shown.Select(change => change.V), Is.EqualTo(expected.Select(change => change.V)));
            for (var i = 0; i < expected.Count; i++)
                Assert.That(shown[i].T - expected[i].T, Is.GreaterThanOrEqualTo(0).And.LessThan(MaxDelay), $"change {i} at {expected[i].T} s");
        }
    }

    [Test]
    public void Report_CellWithoutSignals_HasNone()
    {
        var playback = PlaybackOf(VirtualStage.Play(VirtualDemo.Settings(6, "wifi", 1, hasWork: false), hasScene: false));

        Assert.That(playback.GetProperty("signals").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }
}
