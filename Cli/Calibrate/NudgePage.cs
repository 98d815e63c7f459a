using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;

namespace Nowpose.Cli.Calibrate;

/// <summary>Creates the page for marks set by eye. The slope of the offset over the velocity is the error of L_visu.</summary>
static class NudgePage
{
    public static CalibrationPageData Of(NudgeMarks marks, NudgeResult result, LatencyProfile profile)
    {
        var visuMs = result.Visualisation.Length.TotalMilliseconds;
        return new("L_visu by eye",
            NudgePageTexts.Result(visuMs, result.Spread.TotalMilliseconds, result.OffsetMm),
            [
                .. ProfileFacts.Of(profile),
                [NudgePageTexts.UsedVisu, Number(marks.ConfiguredMs) + " ms"], ["Speed", Number(marks.SpeedMmPerS) + " mm/s"],
                [NudgePageTexts.BaseOffset, Number(result.OffsetMm) + " mm"],
                ["Offsets forwards", Numbers(marks.ForwardMm)], ["Offsets backwards", Numbers(marks.BackwardMm)],
            ])
        {
            Sections = [Section(marks, result)],
        };
    }

    public static string Json(NudgeResult result) => JsonText.Of(new
    {
        VisuMs = result.Visualisation.Length.TotalMilliseconds, VisuSpreadMs = result.Spread.TotalMilliseconds, result.OffsetMm, Measurements = result.Count,
    });

    static CalibrationSection Section(NudgeMarks marks, NudgeResult result)
    {
        var visuMs = result.Visualisation.Length.TotalMilliseconds;
        // Extends the line so that the marks do not lie on the plot's edges.
        const double Beyond = 1.2;
        var v = marks.SpeedMmPerS;
        double? At(double velocity) => result.OffsetMm + velocity * (visuMs - marks.ConfiguredMs) / 1000;
        return new(NudgePageTexts.OffsetOverVelocity, null,
            NudgePageTexts.OffsetOverVelocityNote,
            [new("Offset", new("velocity", "mm/s"), new("offset", "mm"),
            [
                PlotTrace.Points("marks", Looks.Hold, [.. marks.BackwardMm.Select(each => (-v, each)), .. marks.ForwardMm.Select(each => (v, each))]),
                new("line", Looks.Adaptive, [-Beyond * v, Beyond * v], [At(-Beyond * v), At(Beyond * v)]),
            ])]);
    }

    static string Numbers(double[] values) => string.Join(", ", values.Select(Number)) + " mm";

    static string Number(double value) => value.ToString("0.##", CultureInfo.InvariantCulture);
}
