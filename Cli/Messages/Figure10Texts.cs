namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 10.</summary>
static class Figure10Texts
{
    public const string Display =
        "A simulated display of 59.94 Hz: the render time is 4 ms plus 8.5 ms per million vertices, ± 3 %; one frame in a hundred is much slower. A "
        + "frame that is not ready 1.5 ms before a refresh waits for the next one. A frame starts at a refresh, or, while two frames are in "
        + "progress, when the older one is done: if the render time exceeds a refresh interval, frames start at any time between two refreshes. "
        + "The pictures are those of calibrate simulate, about 8 per second and 100 per load, and all codes are read correctly. Each picture "
        + "shows a frame that is lit once for 4 ms. The exposure is 1 ms, and its middle is at a random time while the frame is lit. The headset's "
        + "code has a resolution of 1 ms, and the render time is that of the newest finished frame. The paper states neither its camera's exposure "
        + "nor how long a HoloLens 2 lights a frame. If one of them is longer, or a frame is lit twice, L_visu scatters more within the range, and "
        + "the ratio is smaller. The limit and L_visu depend on the headset: the figure shows the shape, not the values of a HoloLens.";

    public const string Title = "Render time and L_visu at two loads";

    public const string Claim =
        "At a normal load (300 000 vertices), render time and L_visu have a constant relationship; at a high load (1 500 000), this "
        + "relationship is no longer valid.";

    public static string Criterion(double ms) => $"At 300 000 vertices, the standard deviation of the middle 95 % of L_visu is below {ms} ms.";
}
