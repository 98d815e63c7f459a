using Nowpose.Cli.Messages;
using Nowpose.Cli.Recommend;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Recommend;

public class RecordingTraitsTests
{
    const int Seed = 11;

    // Returns the traits of a recording of 12 s at 100 Hz.
    static RecordingTraits Traits(Func<double, double> position, Func<int, double> time = null, int count = 1201)
    {
        var times = Enumerable.Range(0, count).Select(i => time?.Invoke(i) ?? i * 0.01).ToArray();
        return new RecordingTraits([new JointSeries("a", times, [.. times.Select(position)])]);
    }

    [Test]
    public void Warnings_CleanSwing_AreEmpty()
    {
        var traits = Traits(Math.Sin);

        Assert.That(traits.Duration, Is.EqualTo(12).Within(1e-9));
        Assert.That(traits.Interval, Is.EqualTo(0.01).Within(1e-9));
        Assert.That(traits.Repeats, Is.EqualTo(0));
        Assert.That(traits.RoundingSteps, Is.Empty);
        Assert.That(traits.Warnings(), Is.Empty);
    }

    [Test]
    public void Warnings_ShortRecording_StateTheDuration()
    {
        Assert.That(Traits(Math.Sin, count: 501).Warnings().Single(), Is.EqualTo(RecommendMessages.Short(5, 10)));
    }

    [Test]
    public void Warnings_AlmostLongEnough_AreEmpty() => Assert.That(Traits(Math.Sin, count: 1000).Warnings(), Is.Empty);

    [Test]
    public void Warnings_NoMotion_ReportThatNoJointMoves()
    {
        var traits = Traits(t => 1 + 1e-6 * Math.Sin(t));

        Assert.That(traits.MaxRange, Is.EqualTo(2e-6).Within(1e-7));
        Assert.That(traits.Warnings().Single(), Is.EqualTo(RecommendMessages.NoMotion(traits.MaxRange)));
    }

    [Test]
    public void Warnings_UnevenStamps_StateTheirSpread()
    {
        var random = new Random(Seed);

        var traits = Traits(Math.Sin, i => i * 0.01 + 0.004 * random.NextDouble());

        var spread = MessageNumbers.In(traits.Warnings().Single(), RecommendMessages.LateStamps(0, 0));
        Assert.That(spread[0], Is.InRange(6, 8), $"P5, ms; seed {Seed}");
        Assert.That(spread[1], Is.InRange(12, 14), $"P95, ms; seed {Seed}");
    }

    [TestCase(9.0, true)]
    [TestCase(10.0, false)]
    [TestCase(null, false)]
    public void Warnings_RowsCoarserThanTheSamples_StateBothIntervals(double? samplingMs, bool warns)
    {
        var times = Enumerable.Range(0, 1201).Select(i => i * 0.01).ToArray();

        var traits = new RecordingTraits([new JointSeries("a", times, [.. times.Select(Math.Sin)])], samplingMs);

        Assert.That(traits.Warnings(), Is.EqualTo(warns ? new[] { ReplayMessages.CoarseRows(10, 9) } : []));
    }

    [Test]
    public void Warnings_MotionWithAGap_StateIt()
    {
        var times = Enumerable.Range(0, 1201).Select(i => i * 0.01 + (i > 600 ? 2 : 0)).ToArray();

        var traits = new RecordingTraits([new JointSeries("a", times, [.. times.Select(Math.Sin)])], samplingMs: 50);

        Assert.That(traits.Warnings(), Is.EqualTo(new[] { ReplayMessages.Gaps(new(1, 2.01)) }));
    }

    [Test]
    public void Warnings_RowsOnlyAtEvents_AreOneAboutTheRows()
    {
        // Rows at 200 ms, and none for 4 s after every 20th row.
        var times = Enumerable.Range(0, 120).Select(i => i * 0.2 + i / 20 * 4).ToArray();

        var traits = new RecordingTraits([new JointSeries("a", times, [.. times.Select(Math.Sin)])], samplingMs: 50);

        Assert.That(traits.Warnings(), Is.EqualTo(new[] { ReplayMessages.CoarseRows(200, 50, new(5, 4.2)) }));
    }

    [Test]
    public void Repeats_RecordingRateAboveTheUpdateRate_IsTheShareOfRepeatedSamples()
    {
        // Every fifth sample repeats the previous one.
        var traits = Traits(t => Math.Sin(Math.Round(t * 100) % 5 == 4 ? Math.Round(t * 100 - 1) / 100 : Math.Round(t * 100) / 100));

        Assert.That(traits.Repeats, Is.EqualTo(0.2).Within(0.01));
        Assert.That(MessageNumbers.In(traits.Warnings().Single(), RecommendMessages.Repeats(0)), Is.EqualTo(new[] { 20 }).Within(1));
    }

    [TestCase(1e-4)]
    [TestCase(0.0005)]
    public void RoundingSteps_RoundedValues_ContainTheStep(double step)
    {
        var traits = Traits(t => Math.Round(Math.Sin(t) / step) * step);

        Assert.That(traits.RoundingSteps.Single().Step, Is.EqualTo(step).Within(1e-9));
    }

    [Test]
    public void MiddleOf_MotionEndsAtRest_IsAtHalfTheDistance()
    {
        double[] ways = [.. Enumerable.Repeat(1.0, 40), .. Enumerable.Repeat(0.0, 40)];

        Assert.That(MotionHalves.MiddleOf(ways), Is.EqualTo(20));
        Assert.That(MotionHalves.MiddleOf([.. ways.Reverse()]), Is.EqualTo(60));
    }

    [Test]
    public void MiddleOf_JumpOrStandstill_KeepsTheMinimumOnBothSides()
    {
        double[] jump = [1.0, .. Enumerable.Repeat(0.0, 99)];

        Assert.That(MotionHalves.MiddleOf(jump), Is.EqualTo(20));
        Assert.That(MotionHalves.MiddleOf(new double[100]), Is.EqualTo(50));
    }
}
