using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
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

    readonly int _seed;
    List<MeasuredPicture> _sweep, _normal, _high;

    public DisplayStudy(FigureSettings settings)
    {
        _seed = settings.Seed;
        Work = [() => _sweep = Sweep(), () => (_normal, _high) = (Pictures(300_000, 1), Pictures(1_500_000, 2))];
    }

    public IReadOnlyList<Action> Work { get; }

    public IEnumerable<Figure> Figures()
    {
        var fit = RangeFit.Fit([.. _sweep.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);
        return [Figure10.Of(_normal, _high), Figure11.OverLoad(_sweep, fit), Figure11.OverRenderTime(_sweep, fit)];
    }

    List<MeasuredPicture> Sweep() => [.. Enumerable.Range(0, Loads).SelectMany(i => Pictures(SweepPlan.MaxVertices / (Loads - 1) * i, 10 + i))];

    /// <summary>Takes pictures at one load, after the effects of the previous load are over.</summary>
    List<MeasuredPicture> Pictures(int vertices, int run)
    {
        const int Settle = 30, FramesPerPicture = 3;
        var random = new Random(1000 * _seed + run);
        var pipeline = new DisplayPipeline(1000 * _seed + run);
        var pictures = new List<MeasuredPicture>(PicturesPerLoad);
        for (var i = -Settle; i < FramesPerPicture * PicturesPerLoad; i++)
        {
            var frame = pipeline.Next(vertices);
            if (i < 0 || i % FramesPerPicture != 0) continue;
            var normal = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            pictures.Add(new(null, vertices, frame.RenderTime.TotalMilliseconds, frame.Visualisation.TotalMilliseconds + CameraMs * normal));
        }
        return pictures;
    }
}
