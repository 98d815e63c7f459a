using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Vision;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>
/// Calibration of the simulated headset with the paper's method: pictures of both codes, evaluated in the same way as by <c>calibrate vlc</c>.
/// </summary>
/// <param name="Profile">The profile for the run.</param>
/// <param name="Page">The page that shows the calibration.</param>
sealed record PaperCalibration(LatencyProfile Profile, CalibrationPageData Page)
{
    const int LoadSteps = 10;

    /// <summary>Added to the run's seed, so that no run has the same frames as the calibration.</summary>
    const int SeedOffset = 1_000_003;

    /// <param name="settings">The settings, including the error that is added to L_visu.</param>
    /// <param name="picturesPerLoad">Number of pictures at each of the 11 loads.</param>
    /// <returns>Null if the user cancels.</returns>
    /// <exception cref="DemoFailedException">L_visu cannot be determined from the pictures.</exception>
    public static PaperCalibration Of(DemoSettings settings, int picturesPerLoad, CancellationToken cancel)
    {
        var count = picturesPerLoad * (LoadSteps + 1);
        var simulation = new SimulationSettings
        {
            Pictures = count, LoadSteps = LoadSteps, Display = DemoDisplay.Settings(settings), Seed = settings.Seed + SeedOffset,
        };
        var sweep = new SimulatedSweep(simulation);
        var camera = new SimulatedCamera(simulation, sweep);
        var pictures = Enumerable.Range(0, count).Select(i => PictureRequest.Made(camera.Take(i, out _)));
        var result = new VlcRun(new PictureReader(0, 0)).Run(pictures, count, place => FormattableString.Invariant($"picture {place + 1}"), cancel);
        if (cancel.IsCancellationRequested) return null;
        var conditions = new DisplayConditions(SweepTable.Device(sweep.Rows), SweepTable.DisplayHz(sweep.Rows));
        var evaluation = new VlcEvaluation(result, sweep.Rows, EarlierProfile.Read(null, conditions));
        if (evaluation.Profile == null)
            throw new DemoFailedException(DemoMessages.NoCalibration(result.Read.Count, count));
        return new PaperCalibration(WithError(evaluation.Profile, settings.VisualisationErrorMs), evaluation.Page);
    }

    static LatencyProfile WithError(LatencyProfile measured, double errorMs) => errorMs == 0 ? measured : new LatencyProfile(
        Math.Clamp(measured.Visualisation.Length.TotalMilliseconds + errorMs, 0, LatencyProfile.MaxVisuMs), measured.Spread.TotalMilliseconds, measured.Conditions,
        measured.MeasuredUtc, measured.Method, measured.Measurements, measured.Range?.Limit.TotalMilliseconds, measured.RenderTimeSource,
        measured.ValidToRenderTime?.TotalMilliseconds, measured.HeadMotion);
}
