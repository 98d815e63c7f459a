using Nowpose.Cli.Calibrate.Simulate;
using Nowpose.Simulation;

namespace Nowpose.Cli.Figures.Display;

/// <summary>The simulated display of Figs 10 and 11.</summary>
static class StudiedDisplay
{
    /// <summary>Refresh interval of the simulated display, ms.</summary>
    public const double RefreshMs = SimulatedSweep.RefreshMs;

    /// <summary>Render time limit of the simulated display, ms: one refresh interval minus the latch time.</summary>
    public const double TrueLimitMs = RefreshMs - DisplayPipelineSettings.LatchMs;

    public const string Words = Figure10Texts.Display;
}
