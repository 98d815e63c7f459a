using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Conditions under which the swing is seen.</summary>
sealed record SwingScenario(string Name, Func<FigureSettings, StudySettings> Study)
{
    /// <summary>Those of all other figures.</summary>
    public static readonly SwingScenario Standard = new("L 100 ms", settings => settings.Study with { WarmUp = 0 });

    /// <summary>
    /// Those of the paper's realisation: it tells that L was known within 4 ms; the latencies are ours, of a plant whose
    /// middleware takes 60 to 110 ms and a display that takes 40.
    /// </summary>
    public static readonly SwingScenario Realisation = new("L 100 to 150 ms, known to ±4 ms", settings => settings.Study with
    {
        WarmUp = 0,
        Latency = 0.100,
        LatencySpread = 0.050,
        RandomLatencyError = 0.004,
    });
}
