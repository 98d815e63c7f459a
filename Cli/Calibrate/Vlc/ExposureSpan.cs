namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// The part of the display's refresh interval over which the exposures of a series are distributed. If a camera is in step with the display, all
/// pictures show the same part of the lit time, and the mean of L_visu is wrong by a constant error.
/// </summary>
/// <param name="Ms">Length of the part, ms. For exposures at random times, it is the refresh interval or more.</param>
/// <param name="DisplayHz">Refresh rate of the display; null if unknown.</param>
readonly record struct ExposureSpan(double Ms, double? DisplayHz)
{
    /// <summary>Rates for an unknown display: a slow one for the error, and a fast one so that it gets no unnecessary warning.</summary>
    const double SlowHz = 60, FastHz = 90;

    /// <summary>Minimum part of the refresh interval.</summary>
    const double MinShare = 0.5;

    /// <summary>Minimum number of pictures: the standard deviation of fewer is too uncertain.</summary>
    const int MinPictures = 10;

    /// <summary>Maximum deviation of the times between pictures from multiples of one interval, ms, and their minimum share.</summary>
    const double MaxJitterMs = 2, MinShareFixed = 0.8;

    public bool IsNarrow => Ms < MinShare * 1000 / (DisplayHz ?? FastHz);

    /// <summary>Maximum error of the mean of L_visu, ms.</summary>
    public double MaxErrorMs => Math.Max(0, 1000 / (DisplayHz ?? SlowHz) - Ms) / 2;

    /// <summary>
    /// Estimates the part from the pictures that were read. These lie within the time in which the code is visible; the others, in the same
    /// proportion, outside it. Pictures without a fixed interval are assumed to be distributed evenly.
    /// </summary>
    /// <param name="spreadMs">Standard deviation of L_visu, ms; null if unknown.</param>
    public static ExposureSpan Of(VlcResult result, double? spreadMs, double? displayHz) => new(
        result.Read.Count < MinPictures || spreadMs == null || !HaveFixedInterval(result.Read)
            ? double.PositiveInfinity
            : Math.Sqrt(12) * spreadMs.Value * result.Pictures.Count / result.Read.Count,
        displayHz);

    // Pictures that were not read leave gaps of several intervals.
    static bool HaveFixedInterval(IReadOnlyList<PictureResult> read)
    {
        double[] gaps = [.. Enumerable.Range(1, read.Count - 1).Select(i => PictureResult.IntervalMs(read[i - 1], read[i]))];
        var interval = Quantile.Of(gaps, 0.5);
        return gaps.Count(gap => Math.Abs(gap - interval * Math.Max(1, Math.Round(gap / interval))) < MaxJitterMs) >= MinShareFixed * gaps.Length;
    }
}
