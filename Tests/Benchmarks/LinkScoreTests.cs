using System.Globalization;
using Nowpose.Benchmarks.Links;
using Nowpose.Headless.Tests.Cli;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Scores session files with known errors against the true values, which have the format of the gateway's output.</summary>
public class LinkScoreTests
{
    const int FramesPerSecond = 50;
    static readonly int Joints = Nowpose.Gateway.Plants.RobotFiles.Load("youbot").MovingJoints.Count;
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);
    static readonly TimeSpan HoldAge = TimeSpan.FromMilliseconds(100);
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(300);
    static readonly LinkTruth Truth = new("c1_ns = 1700000000000000000 + 1.0002 * monotonic_ns", "1700000299000000000", "youbot");

    [Test]
    public void ControlAt_ClockLineOfTheGateway_Interpolates()
    {
        // A skew of 200 ppm over 300 s gives 60 ms.
        Assert.That(Truth.ControlAt(Start).Nanoseconds, Is.EqualTo(1_700_000_300_060_000_000));
    }

    [Test]
    public void Result_FramesEqualToTheTruth_HasNoError()
    {
        var result = Score(20, _ => "current");

        Assert.That(result.RmsMm, Is.LessThan(0.001));
        Assert.That(result.HoldRmsMm, Is.GreaterThan(1));
        Assert.That(result.Reduction, Is.GreaterThan(0.999));
        Assert.That(result.CurrentAfterS, Is.Zero);
        Assert.That(result.CurrentShare, Is.EqualTo(1));
        Assert.That(result.LongestNotCurrentS, Is.Zero);
        Assert.That(result.ClockErrorUsMax, Is.LessThan(0.2));
        Assert.That(result.WithinStatedShare, Is.EqualTo(1));
        Assert.That(result.FrameLateMsP99, Is.Zero.Within(1e-3));
    }

    [Test]
    public void Result_LateFrames_HasErrorsOfClockAndTool()
    {
        var result = Score(20, _ => "current", clockErrorUs: 20_000, statedUs: i => i % 4 == 0 ? 20_001 : 19_999);

        Assert.That(result.ClockErrorUsP50, Is.EqualTo(20_000).Within(0.2));
        Assert.That(result.WithinStatedShare, Is.EqualTo(0.25));
        // The frames are 20 ms late, and the uncompensated pose is 100 ms late. By the triangle inequality, the reduction must be in this range.
        Assert.That(result.Reduction, Is.InRange(0.77, 0.8));
    }

    [Test]
    public void Result_NoStatedError_CountsAsOutsideTheStatedError()
    {
        var result = Score(5, _ => "current", statedUs: _ => null);

        Assert.That(result.WithinStatedShare, Is.Zero);
        Assert.That(result.StatedErrorUsP50, Is.Null);
    }

    [Test]
    public void Result_PoseNotCurrent_CountsFromTheFirstCurrentFrame()
    {
        var result = Score(10, i => i < 100 ? "unsynchronised" : i is >= 200 and < 225 or 300 ? "held" : "current", synchronisedAt: 90);

        Assert.That(result.CurrentAfterS, Is.EqualTo(2).Within(1e-6));
        Assert.That(result.SynchronisedAfterS, Is.EqualTo(1.8).Within(1e-6));
        Assert.That(result.CoarseAfterS, Is.EqualTo(1.8).Within(1e-6));
        Assert.That(result.CurrentShare, Is.EqualTo(374 / 400.0).Within(1e-9));
        Assert.That(result.LongestNotCurrentS, Is.EqualTo(0.5).Within(1e-6));
    }

    [Test]
    public void Result_PoseNeverCurrent_HasNoScores()
    {
        var result = Score(5, _ => "unsynchronised");

        Assert.That(new[] { result.CurrentAfterS, result.CurrentShare, result.Reduction, result.ClockErrorUsP50 }, Is.All.Null);
        Assert.That(LinkLimits.Missed([result]).Count(), Is.EqualTo(5), "each limit that is not met");
    }

    [Test]
    public void Result_SeveralStalls_ReturnsTheLongestTimes()
    {
        // The link starts together with the frames. It stalls from 8 to 9.5 s and from 16 to 17.5 s.
        var result = Score(
            20, i => (i / (double)FramesPerSecond) is >= 8.2 and < 9.6 or >= 16.1 and < 17.9 ? "held" : "current", LinkProfile.Roaming);

        Assert.That(result.HeldAfterS, Is.EqualTo(0.2).Within(1e-6));
        Assert.That(result.RecoveredAfterS, Is.EqualTo(0.4).Within(1e-6));
        Assert.That(LinkLimits.Missed([result]), Is.Empty);
    }

    [Test]
    public void Result_PoseCurrentDuringAStall_ExceedsTheLimit()
    {
        var result = Score(20, _ => "current", LinkProfile.Roaming);

        Assert.That(result.HeldAfterS, Is.GreaterThan(3));
        Assert.That(LinkLimits.Missed([result]).Single(), Does.StartWith("roaming: time until the pose is shown as held: "));
    }

    [Test]
    public void Missed_NoStallInTheRun_NamesBothStallLimits()
    {
        var result = Score(5, _ => "current", LinkProfile.Roaming);

        Assert.That(
            LinkLimits.Missed([result]).Select(line => line.Split(": ")[1]),
            Is.EqualTo(new[] { "time until the pose is shown as held", "time until the pose is current again" }));
    }

    [Test]
    public void Median_ValueMissingInHalfOfTheRuns_IsNull()
    {
        var good = Score(5, _ => "current");
        var never = Score(5, _ => "unsynchronised");

        Assert.That(LinkLimits.Median([good, never], run => run.CurrentAfterS), Is.Null);
        Assert.That(LinkLimits.Median([good, never, good], run => run.CurrentAfterS), Is.Zero);
        Assert.That(LinkLimits.Missed([good, never, good]).Single(), Does.Contain("time until the pose is current in the worst run: none"));
    }

    static LinkResult Score(
        double seconds, Func<int, string> state, LinkProfile profile = null, double clockErrorUs = 0, Func<int, double?> statedUs = null,
        int synchronisedAt = 0)
    {
        statedUs ??= _ => 1000;
        var error = TimeSpan.FromMicroseconds(clockErrorUs);
        var lines = new List<string> { """{"kind":"session","format":"nowpose-session","version":1}""" };
        for (var i = 0; i < seconds * FramesPerSecond; i++)
        {
            var start = Start + TimeSpan.FromSeconds(i / (double)FramesPerSecond);
            if (i == synchronisedAt) lines.Add($$"""{"kind":"clock","at_ns":{{start.Nanoseconds}},"state":"synchronised","steps":0}""");
            var light = Truth.ControlAt(start) + Visualisation - error;
            var seen = Truth.ControlAt(start + Visualisation);
            var stated = statedUs(i) is double us ? FormattableString.Invariant($",\"estimated_error_ns\":{us * 1000:0}") : "";
            lines.Add(
                $$"""{"kind":"frame","start_ns":{{start.Nanoseconds}},"light_ns":{{light.Nanoseconds}},"state":"{{state(i)}}", """
                + $$""" "joints":{{JointsAt(seen - error)}},"held":{{JointsAt(seen - HoldAge)}}{{stated}}}""");
        }

        using var file = new TemporaryFile(string.Join('\n', lines), ".jsonl");
        return new LinkScore(RecordedFrames.Read(file.Path), Truth, "youbot", Visualisation, FramesPerSecond)
            .Result(profile ?? LinkProfile.Clean, Start, seed: 1);
    }

    static string JointsAt(ControlTime time)
    {
        var joints = new double[Joints];
        Truth.JointsAt(time, joints);
        return "[" + string.Join(',', joints.Select(joint => joint.ToString("R", CultureInfo.InvariantCulture))) + "]";
    }
}
