using Nowpose.Latency;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds the frame of a sweep that a picture's headset code belongs to.</summary>
/// <remarks>
/// Codes repeat after 65.5 s, and sweeps last longer, so a code may match several frames. Pictures come in the order in which they were
/// taken. Of all assignments whose frames never go back, the one with the most assigned pictures is used. A picture that was misread, or
/// whose frame is not in the log, stays unassigned and does not affect the others. The camera may start at any time.
/// </remarks>
sealed class SweepJoin
{
    readonly IReadOnlyList<SweepRow> _rows;
    readonly RenderTimeSourceKind _source;
    readonly ILookup<int, int> _rowsOfCode;

    /// <param name="source">Source of the render times that are used. A limit is valid for one source only.</param>
    public SweepJoin(IReadOnlyList<SweepRow> rows, RenderTimeSourceKind source)
    {
        _rows = rows;
        _source = source;
        _rowsOfCode = Enumerable.Range(0, rows.Count).ToLookup(row => TimestampCode.ValueOf(rows[row].FrameStart));
    }

    /// <param name="pictures">In the camera's order; pictures that were not read are skipped.</param>
    /// <returns>One entry for each picture whose frame is in the log.</returns>
    public IReadOnlyList<MeasuredPicture> Join(IEnumerable<PictureResult> pictures) =>
        [.. LongestRun([.. pictures.Where(picture => picture.IsRead)]).Select(
            place => new MeasuredPicture(place.Picture.File, _rows[place.Row].Vertices, RenderMsOf(_rows[place.Row]), place.Picture.VisuMs))];

    double? RenderMsOf(in SweepRow row) => row.Source == _source ? row.RenderMs : null;

    /// <summary>Gets the longest run of pictures whose rows never go back.</summary>
    List<Place> LongestRun(IReadOnlyList<PictureResult> pictures)
    {
        // Of all runs of each length so far, the one with the earliest last row.
        var ends = new List<Place>();
        foreach (var picture in pictures)
        {
            // Starts with the last row, so that a picture never follows itself.
            foreach (var row in _rowsOfCode[(int)picture.HeadsetMs].Reverse())
            {
                var length = FirstBeyond(ends, row);
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

    // The rows of the ends are in increasing order.
    static int FirstBeyond(List<Place> ends, int row)
    {
        int low = 0, high = ends.Count;
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (ends[middle].Row > row) high = middle;
            else low = middle + 1;
        }
        return low;
    }

    /// <summary>A picture with its row and its predecessor.</summary>
    sealed record Place(PictureResult Picture, int Row, Place Before);
}
