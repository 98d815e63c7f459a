namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// Pictures of a series whose L_visu lies far from the others': codes that passed the parity by chance. Frames that queue up behind a
/// slow GPU are not so late.
/// </summary>
static class Strays
{
    public const string Fault = "far from the others, misread";

    /// <summary>At 60 Hz twelve frames: no more than two or three are ever under way, and the slowest take some refreshes each.</summary>
    const double FarMs = 200;

    /// <summary>Of fewer pictures nobody can say which ones stray.</summary>
    const int LeastPictures = 10;

    /// <summary>The same pictures, those rejected that stray.</summary>
    public static IReadOnlyList<PictureResult> Rejected(IReadOnlyList<PictureResult> pictures)
    {
        double[] visu = [.. pictures.Where(picture => picture.IsRead).Select(picture => picture.VisuMs)];
        if (visu.Length < LeastPictures) return pictures;
        var middle = Quantile.Of(visu, 0.5);
        return [.. pictures.Select(picture => picture.IsRead && Math.Abs(picture.VisuMs - middle) > FarMs ? PictureResult.Not(picture.File, Fault) : picture)];
    }
}
