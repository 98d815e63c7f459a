using System.Reflection;
using Nowpose.Samples;
using Nowpose.Session;
using NUnit.Framework;
using KnobRange = UnityEngine.RangeAttribute;
using static Nowpose.Unity.Tests.Samples.SampleErrors;

namespace Nowpose.Unity.Tests.Samples;

public class VirtualCellKnobTests
{
    static readonly (string Name, KnobRange Range)[] Knobs =
    [
        .. typeof(SimulatedControlSystem).GetFields(BindingFlags.NonPublic | BindingFlags.Instance)
            .Select(field => (field.Name, field.GetCustomAttribute<KnobRange>())).Where(knob => knob.Item2 != null),
    ];

    static IEnumerable<TestCaseData> Ends() => Knobs.SelectMany(knob => new[]
    {
        new TestCaseData(knob.Name, knob.Range.min), new TestCaseData(knob.Name, knob.Range.max),
    });

    [TestCaseSource(nameof(Ends))]
    public void Setting_ChangedToItsLimitAndBackWhilePlaying_DoesNotThrow(string knob, float value)
    {
        using var sample = new PlayedSample().Start().Run(5);
        var usual = sample.Control.Shown(knob);

        sample.Control.With(knob, value);
        sample.Run(8);
        var atTheEnd = (sample.Errors.Count, Errors: sample.Errors.ToList(), HoldErrors: sample.HoldErrors.ToList());
        sample.Control.With(knob, usual);
        sample.Run(12);

        Assert.That(Complaints(sample), Is.Empty);
        Assert.That(sample.States[^1], Is.EqualTo(PoseState.Current));
        // Beyond the predictable range, the pose is current only until the last samples are too old.
        Assert.That(atTheEnd.Count, Is.GreaterThan(10));
        Assert.That(Rms(atTheEnd.Errors), Is.LessThan(0.5 * Rms(atTheEnd.HoldErrors)), "the error of current poses without compensation is larger");
    }

    [Test]
    public void Settings_RandomValues_DoNotThrow([NUnit.Framework.Range(1, 8)] int seed)
    {
        var random = new Random(seed);
        using var sample = new PlayedSample().Start().Run(3);
        for (var turn = 0; turn < 10; turn++)
        {
            foreach (var (name, range) in Knobs) sample.Control.With(name, range.min + (range.max - range.min) * (float)random.NextDouble());
            sample.Control.With("_network", (SimulatedNetwork)random.Next(3));
            sample.Run(0.5);
        }

        Assert.That(Complaints(sample), Is.Empty, "seed " + seed);
    }

    [TestCase("_samplingMs", 1000f)]
    [TestCase("_latencyMinMs", 1000f)]
    [TestCase("_loss", 1f)]
    public void Setting_BeyondThePredictableRange_PoseIsNotCurrent(string knob, float value)
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Control.With(knob, value);
        sample.Run(2);
        sample.Run(5);

        Assert.That(sample.States, Is.Not.Empty.And.None.EqualTo(PoseState.Current));
    }

    [Test]
    public void ClockAhead_ChangedWhilePlaying_IsDetectedAsAStep()
    {
        using var sample = new PlayedSample().Start().Run(6);

        sample.Control.With("_clockAheadSeconds", -500f);
        sample.Run(8);
        sample.Run(10);

        Assert.That(sample.Session.Statistics.ClockSteps, Is.EqualTo(1));
        Assert.That(1 - Rms(sample.Errors) / Rms(sample.HoldErrors), Is.GreaterThan(MinReduction));
    }
}
