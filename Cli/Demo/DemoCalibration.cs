using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>Calibrates the simulated headset before a run with a load, as a user would: a sweep of loads, recorded by a camera.</summary>
static class DemoCalibration
{
    const int Steps = 20;
    const int PicturesPerStep = 50;

    /// <summary>Number of frames in which the queue in front of the display settles.</summary>
    const int FramesBefore = 10;

    /// <param name="settings">The settings, including the error to add to L_visu.</param>
    public static LatencyProfile Of(DemoSettings settings)
    {
        var fit = RangeFit.Fit(Sweep(settings));
        return new LatencyProfile(
            Math.Clamp(fit.VisuMs + settings.VisualisationErrorMs, 0, LatencyProfile.MaxVisuMs), fit.SpreadMs, "simulated headset", DemoDisplay.FramesPerSecond,
            DateTime.UtcNow, CalibrationMethod.VisibleLight, fit.Pairs, fit.LimitRenderMs, RenderTimeSourceKind.DisplayGpuTime, fit.ValidToRenderMs);
    }

    static List<LatencyPair> Sweep(DemoSettings settings)
    {
        // Another seed, so that these are not the run's own frames.
        var display = new DisplayPipeline(settings.Seed + 1, DemoDisplay.Settings(settings));
        var phase = new Random(settings.Seed);
        var pairs = new List<LatencyPair>();
        for (var step = 0; step <= Steps; step++)
        {
            for (var i = -FramesBefore; i < PicturesPerStep; i++)
            {
                var frame = display.Next((double)SweepPlan.MaxVertices * step / Steps);
                if (i >= 0) pairs.Add(new LatencyPair(frame.RenderTime.TotalMilliseconds, Read(frame.Visualisation.TotalMilliseconds, phase)));
            }
        }
        return pairs;
    }

    // The difference of two codes in whole milliseconds, for a picture taken at any time between two codes.
    static double Read(double visuMs, Random phase) => Math.Floor(visuMs + phase.NextDouble());
}
