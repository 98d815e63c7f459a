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

    /// <summary>Mean L_visu within the range, without rejected pairs, ms.</summary>
    public double VisuMs { get; }

    /// <summary>Standard deviation of L_visu between the individual pictures within the range, ms.</summary>
    public double SpreadMs { get; }

    /// <summary>Maximum render time with constant L_visu, ms; null if too few pictures had a higher render time.</summary>
    public double? LimitRenderMs { get; }

    /// <summary>The limit, ms. If there is none, the maximum render time for which a constant L_visu was observed.</summary>
    public double ValidToRenderMs { get; }

    /// <summary>Total number of pairs.</summary>
    public int Pairs { get; }

    /// <summary>Number of pairs from which L_visu and its spread were computed: those within the range and on the plateau.</summary>
    public int Used { get; }

    /// <summary>Number of pairs within the range but not on the plateau: misread pictures, and frames that waited behind a slow one.</summary>
    public int Rejected { get; }

    /// <summary>
    /// Upper end of the interval in which the limit can lie, ms. Set if no pictures were taken between the last one within the range and
    /// this value. Null without a limit, or if the gap is smaller than 5 %.
    /// </summary>
    public double? OpenToRenderMs { get; }

    public string Json() => JsonText.Of(new { VisuMs, VisuSpreadMs = SpreadMs, LimitRenderMs, ValidToRenderMs, Pairs, Rejected });
}
