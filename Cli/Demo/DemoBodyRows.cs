using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Demo;

/// <summary>Formats the errors of the cell's objects as text; has no rows if the cell has no objects.</summary>
sealed class DemoBodyRows(DemoResult.BodyErrors bodies)
{
    public IReadOnlyList<(string Label, string Value)> Rows => bodies == null ? [] :
    [
        (DemoTexts.MovingWorkpieces, Row(bodies.ErrorMm, "0.00", " mm")),
        (DemoTexts.RotatingWorkpieces, Row(bodies.ErrorDeg, "0.00", "°")),
        (DemoTexts.LargestSlip, RunTexts.Number(bodies.LargestSlipMm, "0.00", " mm")),
    ];

    static string Row(DemoResult.PoseErrors error, string format, string unit) => DemoTexts.RmsWithReduction(
        RunTexts.Number(error.HoldRms, format, unit), RunTexts.Number(error.Rms, format, unit), RunTexts.Number(100 * error.Reduction, "0.0", " %"));
}
