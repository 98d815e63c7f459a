using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Sorts the pictures of a long sweep by their names, and checks that this is the order in which they were taken.</summary>
/// <remarks>
/// Codes repeat after 65.5 s. In a longer series, only the order of the pictures determines the period of each picture. The order of the names does not
/// depend on the order in which the pictures are passed to the command.
/// </remarks>
static class TimeOrder
{
    /// <summary>
    /// Minimum share of the steps between consecutive pictures that have the same direction in time. With at least this share, the order of the names
    /// counts as the order in which the pictures were taken, or its reverse.
    /// </summary>
    const double MinShareInOrder = 0.9;

    /// <param name="pictures">Pictures in any order. Those that were not read are ignored.</param>
    /// <returns>The pictures that were read, in the order of their names. Numbers in the names count as numbers.</returns>
    public static IReadOnlyList<PictureResult> ByName(IEnumerable<PictureResult> pictures) =>
        [.. pictures.Where(picture => picture.IsRead).OrderBy(picture => picture.File, new NumberedNames())];

    /// <summary>Returns whether the order of the names is the order in which the pictures were taken, or its reverse.</summary>
    public static bool IsOrderOfNames(IEnumerable<PictureResult> pictures)
    {
        var read = ByName(pictures);
        double[] intervals = [.. read.Skip(1).Select((picture, i) => PictureResult.IntervalMs(read[i], picture))];
        int forward = intervals.Count(ms => ms >= 0), backward = intervals.Count(ms => ms <= 0);
        return Math.Max(forward, backward) >= MinShareInOrder * intervals.Length;
    }
}
