using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>What one picture says.</summary>
/// <param name="File">Its path, or the video's with the frame's number.</param>
/// <param name="LedMs">Control time in the middle of the exposure, 0 to 65 536 ms; NaN when rejected.</param>
/// <param name="HeadsetMs">Start of the frame that was in the light then, 0 to 65 536 ms.</param>
/// <param name="VisuMs">L_visu.</param>
/// <param name="Fault">Why it was rejected; null when it counts.</param>
sealed record PictureResult(string File, double LedMs, double HeadsetMs, double VisuMs, string Fault)
{
    /// <summary>Where both codes are; null when rejected.</summary>
    public CodePlaces Places { get; init; }

    public bool IsRead => Fault == null;

    /// <summary>Control time from one read picture to another, ms; the shorter way round the period of the code, negative backward.</summary>
    public static double IntervalMs(PictureResult from, PictureResult to) => Math.IEEERemainder(to.LedMs - from.LedMs, TimestampCode.PeriodMs);

    public static PictureResult Not(string file, string fault) => new(file, double.NaN, double.NaN, double.NaN, fault);
}
