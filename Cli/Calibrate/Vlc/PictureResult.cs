using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The evaluation of one picture.</summary>
/// <param name="File">Path of the picture, or of the video with the frame's number.</param>
/// <param name="LedMs">Control time at the middle of the exposure, 0 to 65 536 ms; NaN if the picture is rejected.</param>
/// <param name="HeadsetMs">Start time of the frame that was lit at the middle of the exposure, 0 to 65 536 ms.</param>
/// <param name="VisuMs">L_visu, ms.</param>
/// <param name="Fault">Reason for the rejection; null if the picture is valid.</param>
sealed record PictureResult(string File, double LedMs, double HeadsetMs, double VisuMs, string Fault)
{
    /// <summary>Positions of both codes; null if the picture is rejected.</summary>
    public CodePlaces Places { get; init; }

    public bool IsRead => Fault == null;

    /// <summary>
    /// Gets the control time from one picture to another, ms; negative if the second is earlier. Assumes less than half a code period.
    /// </summary>
    public static double IntervalMs(PictureResult from, PictureResult to) => Math.IEEERemainder(to.LedMs - from.LedMs, TimestampCode.PeriodMs);

    public static PictureResult Not(string file, string fault) => new(file, double.NaN, double.NaN, double.NaN, fault);
}
