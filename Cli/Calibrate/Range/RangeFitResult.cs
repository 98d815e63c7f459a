namespace Nowpose.Cli.Calibrate.Range;

/// <summary>The constant-latency range found by <see cref="RangeFit"/>.</summary>
sealed class RangeFitResult
{
    internal RangeFitResult(double visuMs, double spreadMs, double validToMs, bool isReached, int pairs, int used, int rejected, double? openToMs)
    {
        VisuMs = visuMs;
        SpreadMs = spreadMs;
        ValidToRenderMs = validToMs;
        LimitRenderMs = isReached ? validToMs : (double?)null;
        Pairs = pairs;
        Used = used;
        Rejected = rejected;
        OpenToRenderMs = openToMs;
    }

    /// <summary>L_visu: mean within the range without rejected pairs, ms.</summary>
    public double VisuMs { get; }

    /// <summary>Standard deviation of a single picture's L_visu within the range, ms.</summary>
    public double SpreadMs { get; }

    /// <summary>Maximum render time with constant L_visu, ms; null when the loads did not reach it.</summary>
    public double? LimitRenderMs { get; }

    /// <summary>The limit, or else the maximum render time at which a constant L_visu was observed, ms.</summary>
    public double ValidToRenderMs { get; }

    /// <summary>Total number of pairs.</summary>
    public int Pairs { get; }

    /// <summary>Number of pairs used for L_visu and its spread: within the range and on the plateau.</summary>
    public int Used { get; }

    /// <summary>Number of pairs within the range but not on the plateau: misread pictures, and frames that waited behind a slow one.</summary>
    public int Rejected { get; }

    /// <summary>
    /// Upper end of the interval in which the limit may lie, ms, because no pictures were taken in between. Null when the pictures
    /// are close enough, within 5 %, or no limit was reached.
    /// </summary>
    public double? OpenToRenderMs { get; }
}
