using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The result of one picture.</summary>
/// <param name="File">Path of the picture, or of the video with the frame's number.</param>
/// <param name="LedMs">Control time at the middle of the exposure, 0 to 65 536 ms; NaN when rejected.</param>
/// <param name="HeadsetMs">Start of the frame that was lit at that time, 0 to 65 536 ms.</param>
/// <param name="VisuMs">L_visu, ms.</param>
/// <param name="Fault">Reason for the rejection; null when the picture is valid.</param>
sealed record PictureResult(string File, double LedMs, double HeadsetMs, double VisuMs, string Fault)
{
    /// <summary>Places of both codes; null when rejected.</summary>
    public CodePlaces Places { get; init; }

    public bool IsRead => Fault == null;

    /// <summary>Gets the control time from one read picture to another, ms, as the shorter way round the code's period; negative backward.</summary>
    public static double IntervalMs(PictureResult from, PictureResult to) => Math.IEEERemainder(to.LedMs - from.LedMs, TimestampCode.PeriodMs);

    public static PictureResult Not(string file, string fault) => new(file, double.NaN, double.NaN, double.NaN, fault);
}
