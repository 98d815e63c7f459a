namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>A hologram that is held from sample to sample, seen by a camera.</summary>
/// <remarks>
/// Its place is T_s/2 old in the mean, if pictures see it at all ages alike. Where T_s is a multiple of the camera's interval, or near
/// one, all of a recording's pictures see it at a few ages only; which, depends on when the camera was started.
/// </remarks>
static class HeldSteps
{
    const int Starts = 16;

    /// <summary>The greatest difference of the mean age from T_s/2, over all starts of the camera, ms.</summary>
    /// <param name="heldMs">T_s, ms.</param>
    /// <param name="pictureMs">The camera's interval, ms.</param>
    /// <param name="pictures">How many there are.</param>
    public static double GreatestErrorMs(double heldMs, double pictureMs, int pictures) => Enumerable.Range(0, Starts)
        .Max(start => Math.Abs(MeanAge(heldMs, pictureMs, pictures, start * pictureMs / Starts) - heldMs / 2));

    static double MeanAge(double heldMs, double pictureMs, int pictures, double startMs) =>
        Enumerable.Range(0, pictures).Average(picture => (startMs + picture * pictureMs) % heldMs);
}
