using MathNet.Numerics.LinearRegression;
using MathNet.Numerics.Statistics;
using Nowpose.Cli.Calibrate.Vlc;

namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Computes times, positions and speeds from the pictures of a moving headset.</summary>
static class HeadPictures
{
    /// <summary>
    /// Maximum deviation of L_visu from the median. A frame that was repeated or late was not rendered for the time at which it was photographed.
    /// </summary>
    const double MaxVisuDeviationMs = 10;

    /// <summary>Half the time window, s, of the cubic fit whose slope is the speed.</summary>
    const double HalfWindowSeconds = 0.15;

    /// <summary>Minimum number of pictures on each side of the evaluated one, so that the cubic fit does not extrapolate.</summary>
    const int MinNeighbours = 2;

    const int Cubic = 3;

    /// <summary>Quantile of the normal distribution for 95 % confidence, in standard deviations.</summary>
    const double Coverage = 1.96;

    /// <param name="pictures">Pictures in the order in which they were taken.</param>
    /// <param name="visu">Mean L_visu of the used pictures, ms, and half of the 95 % confidence interval of the mean, ms.</param>
    /// <returns>The pictures whose speed is known; empty if there are none.</returns>
    public static IReadOnlyList<HeadPicture> Of(IEnumerable<PictureResult> pictures, out (double MeanMs, double UncertaintyMs) visu)
    {
        PictureResult[] read = [.. pictures.Where(picture => picture.IsRead)];
        var middle = read.Length == 0 ? double.NaN : Quantile.Of(read.Select(picture => picture.VisuMs), 0.5);
        read = [.. InTime(read.Where(picture => Math.Abs(picture.VisuMs - middle) <= MaxVisuDeviationMs))];
        visu = (double.NaN, double.NaN);
        if (read.Length == 0) return [];
        var (mean, deviation) = read.Select(picture => picture.VisuMs).MeanStandardDeviation();
        visu = (mean, Coverage * deviation / Math.Sqrt(read.Length));
        return [.. Along(read, mean)];
    }

    // Skips a picture whose control time is not later than that of the previous picture: a code was misread, or the pictures are out of order.
    static IEnumerable<PictureResult> InTime(IEnumerable<PictureResult> pictures)
    {
        PictureResult last = null;
        foreach (var picture in pictures)
        {
            if (last != null && PictureResult.IntervalMs(last, picture) <= 0) continue;
            yield return last = picture;
        }
    }

    static IEnumerable<HeadPicture> Along(PictureResult[] read, double visuMs)
    {
        var seconds = new double[read.Length];
        for (var i = 1; i < read.Length; i++) seconds[i] = seconds[i - 1] + PictureResult.IntervalMs(read[i - 1], read[i]) / 1000;
        var axis = MotionAxis.Of([.. read.Select(picture => picture.Places.Control)]);
        double[] places = [.. read.Select(picture => axis.PlaceOf(picture.Places.Control))];
        for (var i = 0; i < read.Length; i++)
        {
            if (SpeedAt(i, seconds, places) is not double speed) continue;
            // The picture is not taken at the middle of the lit time, and a rolling shutter exposes the codes at different times.
            // The headset's code is displaced by the speed times both time differences.
            var laterMs = read[i].Places.LaterMs - (read[i].VisuMs - visuMs);
            var offset = axis.LengthOf(read[i].Places.Headset, read[i].Places.Control) - speed * laterMs / 1000;
            yield return new HeadPicture(seconds[i], places[i], speed, offset);
        }
    }

    static double? SpeedAt(int at, double[] seconds, double[] places)
    {
        int from = at, to = at;
        while (from > 0 && seconds[at] - seconds[from - 1] <= HalfWindowSeconds) from--;
        while (to + 1 < seconds.Length && seconds[to + 1] - seconds[at] <= HalfWindowSeconds) to++;
        if (at - from < MinNeighbours || to - at < MinNeighbours) return null;
        double[][] powers = [.. Enumerable.Range(from, to - from + 1).Select(i => seconds[i] - seconds[at])
            .Select(t => Enumerable.Range(0, Cubic + 1).Select(power => Math.Pow(t, power)).ToArray())];
        return MultipleRegression.QR(powers, places[from..(to + 1)])[1];
    }
}

/// <summary>One picture of a moving headset. Positions are measured along the direction of the motion.</summary>
/// <param name="Seconds">Time since the first picture.</param>
/// <param name="Place">Position of the control code relative to its mean, px.</param>
/// <param name="Speed">Speed of the control code in the picture, px/s.</param>
/// <param name="Offset">
/// Position of the headset's code minus position of the control code, px, at the middle of the time in which the frame was lit.
/// </param>
readonly record struct HeadPicture(double Seconds, double Place, double Speed, double Offset);
