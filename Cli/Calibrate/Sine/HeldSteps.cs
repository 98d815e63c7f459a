namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Models a hologram that stays at one position until the next sample, as seen by a camera.</summary>
/// <remarks>
/// The position is T_s/2 old on average if the pictures show all ages equally often. If T_s is close to a multiple of the camera's
/// interval, all pictures of a recording show the same few ages, which depend on the start time of the camera.
/// </remarks>
static class HeldSteps
{
    const int Starts = 16;

    /// <summary>Gets the maximum difference between the mean age and T_s/2 over all start times of the camera, ms.</summary>
    /// <param name="heldMs">T_s, ms.</param>
    /// <param name="pictureMs">The camera's interval, ms.</param>
    /// <param name="pictures">Number of pictures.</param>
    public static double MaxErrorMs(double heldMs, double pictureMs, int pictures) => Enumerable.Range(0, Starts)
        .Max(start => Math.Abs(MeanAge(heldMs, pictureMs, pictures, start * pictureMs / Starts) - heldMs / 2));

    static double MeanAge(double heldMs, double pictureMs, int pictures, double startMs) =>
        Enumerable.Range(0, pictures).Average(picture => (startMs + picture * pictureMs) % heldMs);
}
