using Nowpose.Cli.Replay;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Replay;

public class RecordedTruthTests
{
    static RecordedTruth Truth(Func<double, double> motion, params double[] times)
    {
        var truth = new RecordedTruth(timeLine: 0, TimeSpan.FromMilliseconds(500), isEndless: false);
        foreach (var t in times) truth.Add(ControlTime.FromSeconds(1000 + t), motion(t));
        truth.Complete();
        return truth;
    }

    static double? At(RecordedTruth truth, double t) => truth.TryAt(ControlTime.FromSeconds(1000 + t), out var position) ? position : null;

    [Test]
    public void TryAt_QuadraticMotionSampledUnevenly_IsExact()
    {
        static double Motion(double t) => 3 * t * t - t + 2;
        var truth = Truth(Motion, 0, 0.1, 0.35, 0.2, 0.4, 0.44, 0.6, 0.44);

        for (var t = 0.1; t <= 0.44; t += 0.013)
            Assert.That(At(truth, t), Is.EqualTo(Motion(t)).Within(1e-9), $"{t} s");
    }

    [TestCase(-0.001)]
    [TestCase(0.301)]
    public void TryAt_OutsideTheSamples_IsFalse(double t)
    {
        Assert.That(At(Truth(t => t, 0, 0.1, 0.2, 0.3), t), Is.Null);
    }

    [TestCase(0)]
    [TestCase(0.3)]
    [TestCase(0.15)]
    public void TryAt_WithinTheSamples_EqualsTheMotion(double t)
    {
        Assert.That(At(Truth(t => 2 * t, 0, 0.1, 0.2, 0.3), t), Is.EqualTo(2 * t).Within(1e-9));
    }

    [Test]
    public void TryAt_WithinALongGap_IsFalse()
    {
        var truth = Truth(t => t < 0.5 ? t : 100, 0, 0.1, 0.2, 0.8, 0.9, 1.0);

        Assert.That(At(truth, 0.5), Is.Null);
        Assert.That(At(truth, 0.15), Is.EqualTo(0.15).Within(1e-9));
        Assert.That(At(truth, 0.85), Is.EqualTo(100).Within(1e-9));
    }

    [Test]
    public void TryAt_TooFewSamples_IsFalse()
    {
        Assert.That(At(Truth(t => t), 0), Is.Null);
        Assert.That(At(Truth(t => t, 0), 0), Is.Null);
    }
}
