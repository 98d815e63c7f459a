namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// Rejects pictures whose L_visu is far from that of the other pictures. Their codes were misread and passed the parity check by chance.
/// Frames that wait for a slow GPU are late by less than <see cref="FarMs"/>.
/// </summary>
static class Outliers
{
    public const string Fault = PictureFaults.Stray;

    /// <summary>Maximum distance from the median, ms: twelve frames at 60 Hz. At most three frames are queued, each for a few refreshes.</summary>
    const double FarMs = 200;

    /// <summary>Minimum number of pictures. With fewer, outliers cannot be identified.</summary>
    const int MinPictures = 10;

    /// <summary>Returns the pictures in the same order. Marks the outliers as rejected.</summary>
    public static IReadOnlyList<PictureResult> Rejected(IReadOnlyList<PictureResult> pictures)
    {
        double[] visu = [.. pictures.Where(picture => picture.IsRead).Select(picture => picture.VisuMs)];
        if (visu.Length < MinPictures) return pictures;
        var middle = Quantile.Of(visu, 0.5);
        return [.. pictures.Select(picture => picture.IsRead && Math.Abs(picture.VisuMs - middle) > FarMs ? PictureResult.Not(picture.File, Fault) : picture)];
    }
}
