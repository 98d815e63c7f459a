using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Sine;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Creates the manual's pictures of calibration methods from simulated measurements. They are evaluated like real measurements.</summary>
static class CalibrationPictures
{
    const double CameraHz = 60;

    public static IEnumerable<(string File, FigurePlot Plot)> All()
    {
        var jog = Jog();
        var sine = new SineResult(jog, LagEstimator.Of(jog), SineWay.Of(null, 50, null), new SineCamera());
        var motions = SinePage.Motions(sine).Plots[0];
        yield return ("sine.svg", motions with { Traces = [.. motions.Traces.Take(2)] });
        yield return ("sine-correlation.svg", SinePage.Correlations(sine).Plots[0]);
        var marks = new NudgeMarks(250, 40, [2.1, 1.8], [-2.4, -2.0]);
        yield return ("nudge.svg", NudgePage.Section(marks, marks.Result()).Plots[0]);
    }

    // Simulates a back-and-forth jog of 200 px with a period of 2.2 s. The hologram is 124 ms late, and positions are accurate to 1 px.
    static SineTracks Jog()
    {
        const double Period = 2.2, Lag = 0.124;
        const int Seconds = 6;
        var random = new Random(1);
        double[] Seen(double lag) => [.. Enumerable.Range(0, (int)(Seconds * CameraHz)).Select(
            i => 100 * Math.Sin(2 * Math.PI * (i / CameraHz - lag) / Period) + 2 * random.NextDouble() - 1)];
        return new SineTracks(0, 1 / CameraHz, Seen(0), Seen(Lag));
    }
}
