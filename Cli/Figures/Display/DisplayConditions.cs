using Nowpose.Cli.Calibrate.Simulate;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Conditions of Figs 10 and 11.</summary>
static class DisplayConditions
{
    /// <summary>Refresh interval of the simulated display, ms.</summary>
    public const double RefreshMs = SimulatedSweep.RefreshMs;

    /// <summary>Render time limit of the simulated display, ms: one refresh interval minus the latch time.</summary>
    public const double TrueLimitMs = RefreshMs - 1.5;

    public const string Words = "A simulated display of 59.94 Hz: render time 4 ms and 8.5 ms per million vertices, ± 3 %, one frame in a hundred "
        + "much slower. A frame that is not ready 1.5 ms before a refresh waits for the next one. A frame starts at a refresh, or, while two "
        + "frames are in progress, when the older one is done: above a render time of a refresh interval, frames start at any time between two "
        + "refreshes. The pictures are those of calibrate simulate, about 8 a second, 100 of each load, without errors of reading: each is taken at "
        + "any time within the 4 ms for which its frame is lit, the headset's code has whole milliseconds, and the render time is that of the newest "
        + "finished frame. The paper states neither its camera's exposure nor how long a HoloLens 2 lights a frame; where this is longer, L_visu "
        + "scatters more within the range, and the ratio is smaller. The limit and L_visu depend on the headset: the figure shows the shape, not the "
        + "values of a HoloLens.";
}
