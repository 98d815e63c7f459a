using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Looks at all pictures and reads their codes.</summary>
sealed class VlcRun(PictureReader reader)
{
    readonly SortedDictionary<int, PictureResult> _results = [];
    readonly HashSet<(int Width, int Height)> _sizes = [];

    /// <summary>Sizes of the pictures, where there are several.</summary>
    public IReadOnlyCollection<(int Width, int Height)> MixedSizes => _sizes.Count > 1 ? _sizes : [];

    /// <summary>What there is when the pictures, or the user's patience, have ended.</summary>
    public VlcResult Run(IReadOnlyList<string> files, CancellationToken cancellation)
    {
        var isVideo = PictureFiles.IsVideo(files[0]);
        string NameOf(int place) => isVideo ? FormattableString.Invariant($"{files[0]}#{place + 1}") : files[place];
        using var pool = new VisionPool();
        PictureProgress.Run("reading pictures", isVideo ? null : files.Count, report => pool.Look(
            isVideo ? VideoFrames.Of(files[0]) : files.Select(PictureRequest.File),
            (place, seen) =>
            {
                if (seen.Fault == null) _sizes.Add((seen.Width, seen.Height));
                _results[place] = reader.Read(NameOf(place), seen);
                report(_results.Count);
            },
            cancellation));
        return new VlcResult([.. _results.Values]);
    }
}
