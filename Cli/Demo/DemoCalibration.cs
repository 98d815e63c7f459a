using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>Calibrates the simulated headset before a run with a load, in the same way as a user: with pictures of a load sweep.</summary>
static class DemoCalibration
{
    const int Steps = 20;
    const int PicturesPerStep = 50;

    /// <summary>Number of frames before the first picture of a load, in which the display's queue settles.</summary>
    const int FramesBefore = 10;

    /// <param name="settings">The settings, including the error that is added to L_visu.</param>
    public static LatencyProfile Of(DemoSettings settings)
    {
        var fit = RangeFit.Fit(Sweep(settings));
        return new LatencyProfile(
            Math.Clamp(fit.VisuMs + settings.VisualisationErrorMs, 0, LatencyProfile.MaxVisuMs), fit.SpreadMs, "simulated headset", DemoDisplay.FramesPerSecond,
            DateTime.UtcNow, CalibrationMethod.VisibleLight, fit.Pairs, fit.LimitRenderMs, RenderTimeSourceKind.DisplayGpuTime, fit.ValidToRenderMs);
    }

    static List<LatencyPair> Sweep(DemoSettings settings)
    {
        // The seed differs from the run's, so that the calibration uses different frames.
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

    // Simulates the reading of two codes with a resolution of 1 ms in a picture taken at a random time.
    static double Read(double visuMs, Random phase) => Math.Floor(visuMs + phase.NextDouble());
}
