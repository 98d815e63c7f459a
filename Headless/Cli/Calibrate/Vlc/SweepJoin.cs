using Nowpose.Latency;
using Nowpose.VisibleLight;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Finds the frame of a sweep that a picture's headset code belongs to.</summary>
/// <remarks>
/// Codes repeat after 65.5 s, sweeps last longer: pictures are taken in their order, and each belongs to the first frame with its
/// code that does not lie before the previous picture's.
/// </remarks>
sealed class SweepJoin
{
    readonly IReadOnlyList<SweepRow> _rows;
    readonly ILookup<int, int> _rowsOfCode;

    public SweepJoin(IReadOnlyList<SweepRow> rows)
    {
        _rows = rows;
        _rowsOfCode = Enumerable.Range(0, rows.Count).ToLookup(row => TimestampCode.ValueOf(rows[row].FrameStart));
    }

    /// <param name="pictures">Of the camera's order; those that are not read are left out.</param>
    /// <returns>One of each picture whose frame is in the log.</returns>
    public IReadOnlyList<MeasuredPicture> Join(IEnumerable<PictureResult> pictures)
    {
        var measured = new List<MeasuredPicture>();
        var last = 0;
        foreach (var picture in pictures.Where(picture => picture.IsRead))
        {
            // -1 when no frame has that code, a frame that is not in the log, say of before the sweep.
            var found = _rowsOfCode[(int)picture.HeadsetMs].Where(row => row >= last).DefaultIfEmpty(-1).First();
            if (found < 0) continue;
            last = found;
            measured.Add(new MeasuredPicture(picture.File, _rows[found].Vertices, _rows[found].RenderMs, picture.VisuMs));
        }
        return measured;
    }
}
