using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Formats the results of the pictures as JSON.</summary>
static class VlcJson
{
    /// <param name="profile">Profile that supplies the mean and the deviation. If null, they are computed from the pictures near the median.</param>
    public static string Of(VlcResult result, LatencyProfile profile) => JsonText.Of(new
    {
        Pictures = result.Pictures.Count,
        Decoded = result.Read.Count,
        result.Rejected,
        VisuMsMean = profile?.Visualisation.Length.TotalMilliseconds ?? result.Mean,
        VisuMsSd = profile?.Spread.TotalMilliseconds ?? result.Deviation,
        RejectedPictures = result.Pictures.Where(picture => !picture.IsRead).Select(picture => new { picture.File, Reason = picture.Fault }),
        PerPicture = result.Pictures.Select(picture => new
        {
            picture.File,
            LedMs = picture.IsRead ? Rounded(picture.LedMs) : null,
            HeadsetMs = picture.IsRead ? picture.HeadsetMs : (double?)null,
            VisuMs = picture.IsRead ? Rounded(picture.VisuMs) : null,
        }),
    });

    static double? Rounded(double ms) => Math.Round(ms, 3);
}
