using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Figures.Display;

/// <summary>
/// Figs 10 and 11: L_visu as a function of the load, measured in load sweeps with the display and camera of <c>calibrate simulate</c>.
/// </summary>
sealed class DisplayStudy : IFigureStudy
{
    /// <summary>Number of pictures per load. They take 12 s, in which the start of a frame drifts by several refresh intervals.</summary>
    const int PicturesPerLoad = 100;

    /// <summary>Number of load steps. Each is 100 000 vertices, so that the sweep contains both loads of Fig. 10.</summary>
    const int LoadSteps = 20;

    const int NormalLoad = 300_000, HighLoad = 1_500_000;

    static readonly DisplayPipelineSettings Usual = new(refreshMs: StudiedDisplay.RefreshMs);

    /// <summary>A display whose scene takes twice as long to render per vertex.</summary>
    static readonly DisplayPipelineSettings Costly = new(refreshMs: StudiedDisplay.RefreshMs, msPerMillion: 2 * Usual.MsPerMillion);

    readonly int _seed;
    List<MeasuredPicture> _sweep, _costly;

    public DisplayStudy(FigureSettings settings)
    {
        _seed = settings.Seed;
        Work = [() => _sweep = Sweep(Usual, SweepPlan.MaxVertices, 1), () => _costly = Sweep(Costly, SweepPlan.MaxVertices / 2, 2)];
    }

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures()
    {
        var fit = RangeFit.Fit(_sweep);
        return [Figure10.Of(At(NormalLoad), At(HighLoad)), Figure11.OverLoad(_sweep, fit), Figure11.OverRenderTime(_sweep, fit, RangeFit.Fit(_costly))];
    }

    List<MeasuredPicture> At(int vertices) => [.. _sweep.Where(each => each.Vertices == vertices)];

    List<MeasuredPicture> Sweep(DisplayPipelineSettings display, int maxVertices, int run)
    {
        var sweep = new SimulatedSweep(SimulationSettings.Paper with
        {
            Display = display,
            LoadSteps = LoadSteps,
            MaxVertices = maxVertices,
            Pictures = PicturesPerLoad * (LoadSteps + 1),
            Seed = 10 * _seed + run,
        });
        return [.. sweep.Moments.Select(sweep.Measured)];
    }
}
