using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Figs 10 and 11: the effect of the load on L_visu, from sweeps on the display and with the camera of <c>calibrate simulate</c>.</summary>
sealed class DisplayStudy : IFigureStudy
{
    /// <summary>Pictures of one load take 12 s, in which starts of frames drift through several refreshes.</summary>
    const int PicturesPerLoad = 100;

    /// <summary>Steps of 100 000 vertices, so that both loads of Fig. 10 are loads of the sweep.</summary>
    const int LoadSteps = 20;

    const int NormalLoad = 300_000, HighLoad = 1_500_000;

    static readonly DisplayPipelineSettings Usual = new(refreshMs: DisplayConditions.RefreshMs);

    /// <summary>Another scene: fewer vertices, each of which takes twice as long.</summary>
    static readonly DisplayPipelineSettings Costly = new(refreshMs: DisplayConditions.RefreshMs, msPerMillion: 2 * Usual.MsPerMillion);

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
        var fit = Fit(_sweep);
        return [Figure10.Of(At(NormalLoad), At(HighLoad)), Figure11.OverLoad(_sweep, fit), Figure11.OverRenderTime(_sweep, fit, Fit(_costly))];
    }

    static RangeFitResult Fit(List<MeasuredPicture> sweep) =>
        RangeFit.Fit([.. sweep.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);

    List<MeasuredPicture> At(int vertices) => [.. _sweep.Where(each => each.Vertices == vertices)];

    List<MeasuredPicture> Sweep(DisplayPipelineSettings display, int maxVertices, int run)
    {
        var sweep = new SimulatedSweep(new SimulationSettings
        {
            Display = display, LoadSteps = LoadSteps, MaxVertices = maxVertices, Pictures = PicturesPerLoad * (LoadSteps + 1), Seed = 10 * _seed + run,
        });
        return [.. sweep.Moments.Select(sweep.Measured)];
    }
}
