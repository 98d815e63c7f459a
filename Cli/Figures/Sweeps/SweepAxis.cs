using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>The condition that a sweep changes, in ms. All other conditions are as in the paper.</summary>
sealed record SweepAxis(FigureColumn Column, IReadOnlyList<double> Values, Func<StudySettings, double, StudySettings> With)
{
    const double MsPerSecond = 1000;

    public static readonly SweepAxis SamplingInterval = new(
        new FigureColumn("sampling interval", "ms"), [10, 20, 30, 40, 50, 60, 70, 80, 90, 100],
        (study, ms) => study with { SamplingInterval = ms / MsPerSecond });

    public static readonly SweepAxis Latency = new(
        new FigureColumn("latency", "ms"), [0, 25, 50, 75, 100, 125, 150, 200, 250],
        (study, ms) => study with { Latency = ms / MsPerSecond });

    /// <summary>Error of the end-to-end latency. Positive if the latency is overestimated.</summary>
    public static readonly SweepAxis LatencyError = new(
        new FigureColumn("latency error", "ms"), [-50, -40, -30, -20, -10, 0, 10, 20, 30, 40, 50],
        (study, ms) => study with { LatencyError = ms / MsPerSecond });

    /// <summary>Half the width of the uniform distribution of the errors of t_k.</summary>
    public static readonly SweepAxis StampError = new(
        new FigureColumn("stamp error", "ms"), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
        (study, ms) => study with { StampError = ms / MsPerSecond });
}
