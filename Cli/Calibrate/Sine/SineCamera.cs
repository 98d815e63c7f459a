namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The camera of a jog and the display that it films. The display lights each frame for a part of its refresh interval.</summary>
/// <remarks>
/// A picture shows the robot at the middle of the exposure, but the hologram at the time at which the display was lit. If the camera's interval is a
/// multiple of the display's, this difference is the same in all pictures.
/// </remarks>
/// <param name="ExposureMs">Exposure time, ms; null if unknown: at most the camera's interval.</param>
/// <param name="DisplayHz">Refresh rate of the display; null if unknown.</param>
readonly record struct SineCamera(double? ExposureMs, double? DisplayHz)
{
    const double UsualHz = 60;

    /// <param name="pictureMs">The camera's interval, ms.</param>
    /// <param name="pictures">Number of pictures.</param>
    public double MaxFlashErrorMs(double pictureMs, int pictures) =>
        Math.Min((ExposureMs ?? pictureMs) / 2, HeldSteps.MaxErrorMs(1000 / (DisplayHz ?? UsualHz), pictureMs, pictures));
}
