namespace Nowpose.Cli.Figures.Display;

/// <summary>The conditions of Figs 10 and 11.</summary>
static class DisplayConditions
{
    /// <summary>Refresh interval of the simulated display, ms.</summary>
    public const double RefreshMs = 1000 / 60.0;

    /// <summary>Render time limit of the simulated display: a refresh interval minus the latch, ms.</summary>
    public const double TrueLimitMs = RefreshMs - 1.5;

    public const string Words = "A simulated display of 60 Hz: render time 4 ms and 8.5 ms per million vertices, ± 3 %, one frame in a hundred "
        + "much slower. A frame that is not ready 1.5 ms before a refresh waits for the next one. A frame starts at a refresh, or, while two "
        + "frames are in progress, when the older one is done: above a render time of a refresh interval, frames start at any time between two "
        + "refreshes. About 8 pictures a second are taken of the frames that are seen; the camera's error is 0.7 ms. "
        + "The limit and L_visu depend on the headset: the figure shows the shape, not the values of a HoloLens.";
}
