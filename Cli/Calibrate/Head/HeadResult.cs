using Nowpose.Cli.Calibrate.Vlc;

namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Latency for head motion, evaluated from pictures of a moving headset.</summary>
sealed class HeadResult
{
    /// <param name="displayHz">Refresh rate of the display; null if unknown.</param>
    /// <exception cref="InputException">There is too little motion, or there are too few pictures of it.</exception>
    public HeadResult(VlcResult pictures, double? displayHz = null)
    {
        Pictures = pictures;
        Span = ExposureSpan.Of(pictures, pictures.Deviation, displayHz);
        var moving = HeadPictures.Of(pictures.Pictures, out var visu);
        VisuMs = visu.MeanMs;
        (LatencyMs, var uncertaintyMs, Used) = HeadMotionFit.Of(moving);
        // The mean L_visu is part of the time of every picture, so its uncertainty is added to that of the latency.
        var biasMs = Span.IsNarrow && displayHz.HasValue ? Span.MaxErrorMs : 0;
        UncertaintyMs = Math.Sqrt(uncertaintyMs * uncertaintyMs + visu.UncertaintyMs * visu.UncertaintyMs + biasMs * biasMs);
        SpeedPx = Math.Sqrt(Used.Average(picture => picture.Speed * picture.Speed));
    }

    public VlcResult Pictures { get; }

    /// <summary>The part of the refresh interval that the exposures cover.</summary>
    public ExposureSpan Span { get; }

    /// <summary>Latency for head motion.</summary>
    public double LatencyMs { get; }

    /// <summary>
    /// Half of the 95 % confidence interval. If the camera is in step with the display, includes the possible error of the mean L_visu.
    /// </summary>
    public double UncertaintyMs { get; }

    /// <summary>Mean L_visu of the same pictures, Eq. (7).</summary>
    public double VisuMs { get; }

    /// <summary>Root mean square of the speed, px/s.</summary>
    public double SpeedPx { get; }

    /// <summary>The pictures used in the fit.</summary>
    public IReadOnlyList<HeadPicture> Used { get; }

    public string Json() => JsonText.Of(new
    {
        HeadLatencyMs = LatencyMs, HeadLatencyUncertaintyMs = UncertaintyMs, VisuMs, Pictures = Pictures.Pictures.Count, Pictures.Rejected, Used = Used.Count,
        speed_px_s = SpeedPx,
    });
}
