using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Figs 10 and 11: the effect of the load on L_visu on the simulated display.</summary>
sealed class DisplayStudy : IFigureStudy
{
    const int PicturesPerLoad = 100;
    const int Loads = 21;

    /// <summary>Standard deviation of a camera's reading error, ms: codes are in whole milliseconds.</summary>
    const double CameraMs = 0.7;

    /// <summary>Another scene: fewer vertices, each of which takes twice as long.</summary>
    static readonly DisplayPipelineSettings Usual = new(), Costly = new(msPerMillion: 2 * Usual.MsPerMillion);

    readonly int _seed;
    List<MeasuredPicture> _sweep, _costly, _normal, _high;

    public DisplayStudy(FigureSettings settings)
    {
        _seed = settings.Seed;
        Work =
        [
            () => _sweep = Sweep(SweepPlan.MaxVertices, 10, Usual),
            () => _costly = Sweep(SweepPlan.MaxVertices / 2, 40, Costly),
            () => (_normal, _high) = (Pictures(300_000, 1, Usual), Pictures(1_500_000, 2, Usual)),
        ];
    }

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures()
    {
        var fit = Fit(_sweep);
        return [Figure10.Of(_normal, _high), Figure11.OverLoad(_sweep, fit), Figure11.OverRenderTime(_sweep, fit, Fit(_costly))];
    }

    static RangeFitResult Fit(List<MeasuredPicture> sweep) =>
        RangeFit.Fit([.. sweep.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);

    List<MeasuredPicture> Sweep(int maxVertices, int firstRun, DisplayPipelineSettings display) =>
        [.. Enumerable.Range(0, Loads).SelectMany(i => Pictures(maxVertices / (Loads - 1) * i, firstRun + i, display))];

    /// <summary>Takes pictures at one load, after the effects of the previous load are over.</summary>
    List<MeasuredPicture> Pictures(int vertices, int run, DisplayPipelineSettings display)
    {
        // About 8 pictures a second. The pictures of one load take 12 s, in which starts of frames drift through several refreshes.
        const int Settle = 30, FramesPerPicture = 7;
        var random = new Random(1000 * _seed + run);
        var pipeline = new DisplayPipeline(1000 * _seed + run, display);
        var pictures = new List<MeasuredPicture>(PicturesPerLoad);
        var next = pipeline.Next(vertices);
        for (var seen = -Settle; pictures.Count < PicturesPerLoad;)
        {
            (var frame, next) = (next, pipeline.Next(vertices));
            if (frame.IsReplacedBy(next)) continue;
            if (++seen <= 0 || seen % FramesPerPicture != 0) continue;
            var normal = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            pictures.Add(new(null, vertices, frame.RenderTime.TotalMilliseconds, frame.Visualisation.TotalMilliseconds + CameraMs * normal));
        }
        return pictures;
    }
}
