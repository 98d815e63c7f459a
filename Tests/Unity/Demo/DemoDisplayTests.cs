using Nowpose.Cli.Demo;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests the demo's display, and how the render-time monitor evaluates the data of its driver, in virtual time.</summary>
public class DemoDisplayTests
{
    static readonly DemoSettings Plain = new() { Seconds = 20, VisualisationMs = 40, Seed = 1 };

    [Test]
    public void Render_WithoutLoad_RunsAtSixtyFramesPerSecondWithoutRenderTimes()
    {
        var display = new DemoDisplay(Plain);

        for (var frame = 0; frame < 600; frame++)
        {
            Assert.That(display.NextStart.TotalSeconds, Is.EqualTo(frame / 60.0).Within(1e-6));
            display.Render();
            Assert.That(display.Visualisation, Is.EqualTo(TimeSpan.FromMilliseconds(40)));
            Assert.That(display.DriverTime, Is.Null);
        }
    }

    [TestCase(300_000, 40, false)]
    [TestCase(1_500_000, 56, true)]
    public void Render_LoadOnAndOff_MonitorIsOutsideOnlyWhileTheLoadIsBeyondTheLimit(int vertices, double minVisualisationMs, bool isOutside)
    {
        var display = new DemoDisplay(Plain with { Load = vertices });
        var monitor = new ConstantLatencyMonitor(new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime));
        var (states, lengths) = (new Dictionary<int, RangeState>(), new List<double>());

        while (display.NextStart.TotalSeconds < Plain.Seconds)
        {
            var second = (int)display.NextStart.TotalSeconds;
            display.Render();
            if (display.DriverTime is TimeSpan driver) monitor.Add(driver, RenderTimeSourceKind.DisplayGpuTime);
            states[second] = monitor.State;
            if (second is >= 8 and < 14) lengths.Add(display.Visualisation.TotalMilliseconds);
        }

        Assert.That(states[5], Is.EqualTo(RangeState.Inside), "before");
        Assert.That(states[10], Is.EqualTo(isOutside ? RangeState.Outside : RangeState.Inside));
        Assert.That(states[17], Is.EqualTo(RangeState.Inside), "afterwards");
        Assert.That(lengths.Order().ElementAt(lengths.Count / 2), Is.InRange(minVisualisationMs, minVisualisationMs + 20));
    }

    [Test]
    public void DemoCalibration_SimulatedHeadset_EstimatesItsLatencyAndLimit([Values(1, 2, 3)] int seed)
    {
        var profile = DemoCalibration.Of(Plain with { Load = 0, Seed = seed, VisualisationMs = 43.4, VisualisationErrorMs = 2 });

        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(45.4).Within(0.1), "L_visu includes the error that is added for the runtime");
        Assert.That(profile.Range.Limit.TotalMilliseconds, Is.InRange(0.94 * 15.17, 1.02 * 15.17));
        Assert.That(profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
    }

    [Test]
    public void DriverTime_EachFrame_BelongsToAFrameCompletedBeforeItsStart()
    {
        var display = new DemoDisplay(Plain with { Load = 2_000_000 });
        var renderTimes = new List<(TimeSpan Done, TimeSpan RenderTime)>();

        for (var frame = 0; frame < 900; frame++)
        {
            display.Render();
            var rendered = display.Rendered.Value;
            var known = renderTimes.Where(before => before.Done <= rendered.Start).Select(before => (TimeSpan?)before.RenderTime).LastOrDefault();
            Assert.That(display.DriverTime, Is.EqualTo(known), "frame " + frame);
            renderTimes.Add((rendered.Done, rendered.RenderTime));
        }
    }
}
