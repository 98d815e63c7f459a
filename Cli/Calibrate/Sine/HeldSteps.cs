namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>A hologram that is held from sample to sample, as seen by a camera.</summary>
/// <remarks>
/// Its position is T_s/2 old on average if the pictures see all ages equally often. Where T_s is a multiple of the camera's interval, or
/// near one, all pictures of a recording see only a few ages, which depend on when the camera was started.
/// </remarks>
static class HeldSteps
{
    const int Starts = 16;

    /// <summary>Gets the maximum difference of the mean age from T_s/2, over all starts of the camera, ms.</summary>
    /// <param name="heldMs">T_s, ms.</param>
    /// <param name="pictureMs">The camera's interval, ms.</param>
    /// <param name="pictures">Number of pictures.</param>
    public static double MaxErrorMs(double heldMs, double pictureMs, int pictures) => Enumerable.Range(0, Starts)
        .Max(start => Math.Abs(MeanAge(heldMs, pictureMs, pictures, start * pictureMs / Starts) - heldMs / 2));

    static double MeanAge(double heldMs, double pictureMs, int pictures, double startMs) =>
        Enumerable.Range(0, pictures).Average(picture => (startMs + picture * pictureMs) % heldMs);
}
