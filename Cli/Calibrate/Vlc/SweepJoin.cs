using Nowpose.Latency;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds the frame of a sweep that each picture shows, by the headset's code.</summary>
/// <remarks>
/// Codes repeat after 65.5 s. In a shorter sweep, a code matches one frame, and the pictures can have any order. In a longer sweep, a code
/// can match several frames, and the order of the pictures' names decides between them: the order in which they were taken, or its reverse.
/// The method uses the assignment that keeps this order and assigns the most pictures. A picture that was misread, or whose frame is not
/// in the log, stays unassigned and does not affect the others. The camera can start at any time.
/// </remarks>
sealed class SweepJoin
{
    readonly IReadOnlyList<SweepRow> _rows;
    readonly RenderTimeSourceKind _source;
    readonly ILookup<int, int> _rowsOfCode;

    /// <param name="source">Source of the render times to use. A limit is valid for one source only.</param>
    public SweepJoin(IReadOnlyList<SweepRow> rows, RenderTimeSourceKind source)
    {
        _rows = rows;
        _source = source;
        _rowsOfCode = Enumerable.Range(0, rows.Count).ToLookup(row => TimestampCode.ValueOf(rows[row].FrameStart));
    }

    /// <summary>Whether the sweep is longer than the code's period, so that the pictures need an order.</summary>
    public bool NeedsOrder => _rows.Count > 0 && (_rows[^1].FrameStart - _rows[0].FrameStart).TotalMilliseconds >= TimestampCode.PeriodMs - 1;

    /// <param name="pictures">Pictures in any order. Those that were not read are skipped.</param>
    /// <returns>One entry for each picture whose frame is in the log, in the order of the frames.</returns>
    public IReadOnlyList<MeasuredPicture> Join(IEnumerable<PictureResult> pictures) =>
        [.. Orders([.. pictures.Where(picture => picture.IsRead)]).Select(LongestRun).MaxBy(run => run.Count).Select(
            place => new MeasuredPicture(place.Picture.File, _rows[place.Row].Vertices, RenderMsOf(_rows[place.Row]), place.Picture.VisuMs))];

    /// <summary>Gets the orders in which the pictures can have been taken.</summary>
    IEnumerable<IReadOnlyList<PictureResult>> Orders(IReadOnlyList<PictureResult> read)
    {
        if (NeedsOrder)
        {
            var named = TimeOrder.ByName(read);
            return [named, [.. named.Reverse()]];
        }
        var first = _rows.Count > 0 ? TimestampCode.ValueOf(_rows[0].FrameStart) : 0;
        return [[.. read.OrderBy(picture => ((int)picture.HeadsetMs - first) & (TimestampCode.PeriodMs - 1)).ThenBy(picture => picture.File, StringComparer.Ordinal)]];
    }

    double? RenderMsOf(in SweepRow row) => row.Source == _source ? row.RenderMs : null;

    /// <summary>Gets the largest set of pictures whose frames are in the order of the pictures (longest non-decreasing subsequence).</summary>
    List<Place> LongestRun(IReadOnlyList<PictureResult> pictures)
    {
        // For each length, the last picture of the run of this length that ends at the earliest row.
        var ends = new List<Place>();
        foreach (var picture in pictures)
        {
            // Tries the latest row first, so that a picture never follows itself in a run.
            foreach (var row in _rowsOfCode[(int)picture.HeadsetMs].Reverse())
            {
                // The rows of the ends are in increasing order.
                var length = SortedSearch.CountUpTo(ends, row, end => end.Row);
                var place = new Place(picture, row, length > 0 ? ends[length - 1] : null);
                if (length == ends.Count) ends.Add(place);
                else ends[length] = place;
            }
        }
        var run = new List<Place>();
        for (var place = ends.Count > 0 ? ends[^1] : null; place != null; place = place.Before) run.Add(place);
        run.Reverse();
        return run;
    }

    /// <summary>A picture with its row in the log and the previous picture of the run.</summary>
    sealed record Place(PictureResult Picture, int Row, Place Before);
}
