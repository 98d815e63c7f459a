using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Simulation;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Creates the pairs of a sweep: pictures of about every third frame of a simulated display, some of them misread.</summary>
sealed class SimulatedPictures
{
    const double PlateauMs = 40;

    /// <summary>Loads of the sweep in vertices.</summary>
    public double[] Loads { get; set; } = Enumerable.Range(0, 21).Select(i => 100_000.0 * i).ToArray();

    public int PerLoad { get; set; } = 30;

    /// <summary>Share of pictures with a random L_visu.</summary>
    public double Misread { get; set; } = 0.02;

    /// <summary>Standard deviation of a measured L_visu, ms.</summary>
    public double NoiseMs { get; set; } = 1;

    public DisplayPipelineSettings Display { get; set; } = new DisplayPipelineSettings(plateauMs: PlateauMs);

    public IReadOnlyList<LatencyPair> Take(int seed)
    {
        var random = new Random(seed);
        var pipeline = new DisplayPipeline(seed, Display);
        var pairs = new List<LatencyPair>();
        foreach (var load in Loads)
            for (var taken = 0; taken < PerLoad;)
            {
                var frame = pipeline.Next(load);
                if (random.NextDouble() < 0.7) continue;
                taken++;
                var visuMs = random.NextDouble() < Misread
                    ? -100 + 400 * random.NextDouble()
                    : frame.Visualisation.TotalMilliseconds + NoiseMs * random.NextNormal();
                pairs.Add(new LatencyPair(frame.RenderTime.TotalMilliseconds, visuMs));
            }
        // Pictures can be in any order.
        return pairs.OrderBy(_ => random.Next()).ToArray();
    }
}
