using System.CommandLine;
using System.Globalization;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Simulation;

namespace Nowpose.Benchmarks;

/// <summary>paper: calibrates the simulated display of <c>demo --paper</c> from rendered pictures, once for each seed.</summary>
/// <remarks>A test uses the results as reference data, because rendering and reading the pictures takes minutes of processor time.</remarks>
static class PaperVerb
{
    const double VisuMs = 40;

    public static Command Create()
    {
        var seeds = NumberOption.Create("--seeds", "Number of calibrations", 10, 1, 1000, "");
        var first = NumberOption.Create("--first-seed", "Seed of the first calibration; each further one uses the next seed", 1, 0, 1_000_000, "");
        var command = new Command("paper", "Calibrate the simulated display of demo --paper from rendered pictures, and print the profiles as CSV") { seeds, first };
        command.SetAction((parsed, stop) => Task.FromResult(Run([.. Enumerable.Range(parsed.GetValue(first), parsed.GetValue(seeds))], stop)));
        return command;
    }

    static int Run(int[] seeds, CancellationToken stop)
    {
        var swing = new YoubotSwing(isCold: true);
        Console.WriteLine("seed,visu_ms,spread_ms,measurements,limit_render_ms");
        foreach (var seed in seeds)
        {
            var given = new DemoSettings { Network = NetworkProfile.Wifi, Acquisition = new(55, 105), VisualisationMs = VisuMs, Seed = seed };
            var calibration = PaperCalibration.Of(PaperScenario.Of(given, swing), PaperSession.PicturesPerLoad, stop);
            if (stop.IsCancellationRequested) return ExitStatus.Interrupted;
            Console.WriteLine(Text(seed, calibration.Profile));
        }
        return ExitStatus.Done;
    }

    static string Text(int seed, LatencyProfile profile) => string.Create(
        CultureInfo.InvariantCulture,
        $"{seed},{profile.Visualisation.Length.TotalMilliseconds:0.####},{profile.Spread.TotalMilliseconds:0.####},{profile.Measurements},")
        + string.Create(CultureInfo.InvariantCulture, $"{profile.Range?.Limit.TotalMilliseconds:0.####}");
}
