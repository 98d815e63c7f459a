using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds and reads the codes of all pictures.</summary>
sealed class VlcRun(PictureReader reader)
{
    readonly SortedDictionary<int, PictureResult> _results = [];
    SeenPicture _first;
    string _firstName;

    /// <summary>Evaluates the pictures. Returns the results so far when the user cancels.</summary>
    /// <param name="isStill">Whether the headset must be still. Pictures taken in motion are then rejected.</param>
    /// <exception cref="InputException">The pictures have several sizes, so they come from several cameras or series.</exception>
    public VlcResult Run(IReadOnlyList<string> files, bool isStill, CancellationToken cancellation)
    {
        var isVideo = PictureFiles.IsVideo(files[0]);
        return Run(
            isVideo ? VideoFrames.Of(files[0]) : files.Select(PictureRequest.File), isVideo ? null : files.Count,
            place => isVideo ? FormattableString.Invariant($"{files[0]}#{place + 1}") : files[place], isStill, cancellation);
    }

    /// <summary>Evaluates the pictures of any source. Returns the results so far when the user cancels.</summary>
    /// <param name="count">Number of pictures; null if it is unknown.</param>
    /// <param name="nameOf">Gets the name of a picture from its index.</param>
    /// <inheritdoc cref="Run(IReadOnlyList{string}, bool, CancellationToken)"/>
    public VlcResult Run(
        IEnumerable<PictureRequest> requests, int? count, Func<int, string> nameOf, bool isStill, CancellationToken cancellation)
    {
        using var pool = new VisionPool();
        CountProgress.Run("reading pictures", "pictures", count, report => pool.Look(
            requests,
            (place, seen) =>
            {
                RequireSameSize(seen, nameOf(place));
                _results[place] = reader.Read(nameOf(place), seen);
                report(_results.Count);
            },
            cancellation));
        var pictures = Strays.Rejected([.. _results.Values]);
        return new VlcResult(isStill ? MovingPictures.Rejected(pictures) : pictures);
    }

    void RequireSameSize(SeenPicture seen, string name)
    {
        if (seen.Fault != null) return;
        if (_first == null) (_first, _firstName) = (seen, name);
        if (seen.Width != _first.Width || seen.Height != _first.Height)
            throw new InputException(
                $"{name}: {seen.Width}x{seen.Height} px, but {_firstName} has {_first.Width}x{_first.Height} px; evaluate the pictures of each camera separately");
    }
}
