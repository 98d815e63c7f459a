using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Vision;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>
/// Calibration of the simulated headset with the paper's method: pictures of both codes, evaluated in the same way as by <c>calibrate vlc</c>.
/// </summary>
/// <param name="Profile">The profile for the run; null if the user cancelled before there were enough pictures.</param>
/// <param name="Page">The page that shows the calibration.</param>
sealed record PaperCalibration(LatencyProfile Profile, CalibrationPageData Page)
{
    const int LoadSteps = 10;

    /// <summary>Added to the run's seed, so that no run has the same frames as the calibration.</summary>
    const int SeedOffset = 1_000_003;

    /// <param name="settings">The settings, including the error that is added to L_visu.</param>
    /// <param name="picturesPerLoad">Number of pictures at each of the 11 loads.</param>
    /// <param name="showsProgress">False if this is a part of work whose progress is shown.</param>
    /// <returns>If the user cancels, the evaluation of the pictures so far; null if none could be read.</returns>
    /// <exception cref="DemoFailedException">L_visu cannot be determined from the pictures.</exception>
    public static PaperCalibration Of(DemoSettings settings, int picturesPerLoad, CancellationToken cancel, bool showsProgress = true)
    {
        var count = picturesPerLoad * (LoadSteps + 1);
        var simulation = SimulationSettings.Paper with
        {
            Pictures = count,
            LoadSteps = LoadSteps,
            Display = DemoDisplay.Settings(settings),
            Seed = settings.Seed + SeedOffset,
        };
        var sweep = new SimulatedSweep(simulation);
        var camera = new SimulatedCamera(simulation, sweep);
        var pictures = Enumerable.Range(0, count).Select(i => PictureRequest.Made(camera.Take(i, out _)));
        var result = new VlcRun(new PictureReader(0, 0), showsProgress).Run(
            pictures, count, place => FormattableString.Invariant($"picture {place + 1}"), cancel);
        return Of(result, sweep.Rows, count, settings.VisualisationErrorMs, cancel.IsCancellationRequested);
    }

    /// <param name="pictures">Number of pictures of the complete calibration.</param>
    /// <param name="errorMs">Error that is added to L_visu, ms.</param>
    /// <param name="isInterrupted">Whether the user cancelled, so that pictures are missing.</param>
    /// <inheritdoc cref="Of(DemoSettings, int, CancellationToken)"/>
    internal static PaperCalibration Of(VlcResult result, IReadOnlyList<SweepRow> sweep, int pictures, double errorMs, bool isInterrupted)
    {
        if (isInterrupted && result.Read.Count == 0) return null;
        var conditions = new DisplayConditions(SweepTable.Device(sweep), SweepTable.DisplayHz(sweep));
        var evaluation = new VlcEvaluation(result, sweep, EarlierProfile.Read(null, conditions));
        if (evaluation.Profile == null && !isInterrupted)
            throw new DemoFailedException(DemoMessages.NoCalibration(result.Read.Count, pictures));
        var page = isInterrupted ? evaluation.Page.WithWarning(CalibrationMessages.Interrupted) : evaluation.Page;
        return new PaperCalibration(WithError(evaluation.Profile, errorMs), page);
    }

    static LatencyProfile WithError(LatencyProfile measured, double errorMs) => measured == null || errorMs == 0 ? measured : new LatencyProfile(
        Math.Clamp(measured.Visualisation.Length.TotalMilliseconds + errorMs, 0, LatencyProfile.MaxVisuMs), measured.Spread.TotalMilliseconds, measured.Conditions,
        measured.MeasuredUtc, measured.Method, measured.Measurements, measured.Range?.Limit.TotalMilliseconds, measured.RenderTimeSource,
        measured.ValidToRenderTime?.TotalMilliseconds, measured.HeadMotion);
}
