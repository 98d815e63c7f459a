using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds and reads the codes in all pictures.</summary>
/// <param name="showsProgress">False if this is a part of work whose progress is shown.</param>
sealed class VlcRun(PictureReader reader, bool showsProgress = true)
{
    readonly SortedDictionary<int, (PictureResult Picture, (int Width, int Height) Size)> _results = [];

    /// <summary>Evaluates the pictures. If the user cancels, returns the results so far.</summary>
    public VlcResult Run(IReadOnlyList<string> files, CancellationToken cancellation)
    {
        var isVideo = PictureFiles.IsVideo(files[0]);
        return Run(
            isVideo ? VideoFrames.Of(files[0]) : files.Select(PictureRequest.File), isVideo ? null : files.Count,
            place => isVideo ? FormattableString.Invariant($"{files[0]}#{place + 1}") : files[place], cancellation);
    }

    /// <summary>Evaluates pictures from any source. If the user cancels, returns the results so far.</summary>
    /// <param name="count">Number of pictures; null if it is unknown.</param>
    /// <param name="nameOf">Gets the name of a picture from its index.</param>
    public VlcResult Run(IEnumerable<PictureRequest> requests, int? count, Func<int, string> nameOf, CancellationToken cancellation)
    {
        using var pool = new VisionPool();
        if (showsProgress) ConsoleProgress.Run("reading pictures", "pictures", count, Read);
        else Read(_ => { });
        return new VlcResult(Outliers.Rejected(OfOneSize()));

        void Read(Action<int> report) => pool.Look(
            requests,
            (place, seen) =>
            {
                _results[place] = (reader.Read(nameOf(place), seen), (seen.Width, seen.Height));
                report(_results.Count);
            },
            cancellation);
    }

    /// <summary>Rejects the pictures that do not have the most frequent size, because they come from another camera or series.</summary>
    IReadOnlyList<PictureResult> OfOneSize()
    {
        // Among equally frequent sizes, the largest is kept, so that the order of the pictures has no effect.
        var kept = _results.Values.Select(result => result.Size).Where(size => size.Width > 0).GroupBy(size => size)
            .OrderByDescending(group => group.Count()).ThenByDescending(group => group.Key.Width * (long)group.Key.Height).ThenByDescending(group => group.Key.Width)
            .Select(group => group.Key).FirstOrDefault();
        return [.. _results.Values.Select(result => result.Size.Width == 0 || result.Size == kept
            ? result.Picture
            : PictureResult.Not(
                result.Picture.File,
                PictureFaults.OtherSize(result.Size.Width, result.Size.Height, kept.Width, kept.Height)))];
    }
}
