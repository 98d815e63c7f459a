using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Conditions under which the swing is seen.</summary>
/// <param name="IsCold">Whether nothing is known of the robot's motion before.</param>
sealed record SwingScenario(string Name, bool IsCold, Func<StudySettings, StudySettings> With)
{
    /// <summary>Those of all other figures.</summary>
    public static readonly SwingScenario Standard = new("L 100 ms", false, study => study);

    /// <summary>
    /// Those of the paper's realisation: it tells that L was known within 4 ms; the latencies are ours, of a plant whose
    /// middleware takes 60 to 110 ms and a display that takes 40.
    /// </summary>
    public static readonly SwingScenario Realisation = new("L 100 to 150 ms, known to ±4 ms", false, study => study with
    {
        Latency = 0.100,
        LatencySpread = 0.050,
        RandomLatencyError = 0.004,
    });

    /// <summary>The standard ones, for the first move that the headset ever sees.</summary>
    public static readonly SwingScenario Cold = new("L 100 ms, first move ever seen", true, study => study);
}
