using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Conditions under which the swing is seen.</summary>
/// <param name="IsCold">Whether the motion before the swing is unknown.</param>
sealed record SwingScenario(string Name, bool IsCold, Func<StudySettings, StudySettings> With)
{
    /// <summary>The conditions of all other figures.</summary>
    public static readonly SwingScenario Standard = new("L 100 ms", false, study => study);

    /// <summary>
    /// The conditions of the paper's realisation. The paper states that L was known within 4 ms. The latencies are our assumption: a plant
    /// whose middleware takes 60 to 110 ms and a display that takes 40 ms.
    /// </summary>
    public static readonly SwingScenario Realisation = new("L 100 to 150 ms, known to ±4 ms", false, study => study with
    {
        Latency = 0.100,
        LatencySpread = 0.050,
        RandomLatencyError = 0.004,
    });

    /// <summary>The standard conditions, for the first move that the headset receives.</summary>
    public static readonly SwingScenario Cold = new("L 100 ms, first move ever seen", true, study => study);
}
