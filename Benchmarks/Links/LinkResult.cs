namespace Nowpose.Benchmarks.Links;

/// <summary>One run over one link, compared with the truth. Null stands for values that do not exist.</summary>
/// <param name="CurrentAfterS">Time from the first frame to the first current one.</param>
/// <param name="CoarseAfterS">Time from the first frame until the clock was coarse or synchronised.</param>
/// <param name="CurrentShare">Share of the current frames since the first current one. All following values also start there.</param>
/// <param name="Reduction">1 − RMS tool error over that of a headset without compensation.</param>
/// <param name="ClockErrorUsP50">Error of the frames' control time.</param>
/// <param name="StatedErrorUsP50">The uncertainty that the headset states for its clock.</param>
/// <param name="WithinStatedShare">Share of the frames whose clock error is at most the stated one.</param>
/// <param name="HeldAfterS">Time from a stall's start to the first frame that was not current; the longest of the run.</param>
/// <param name="RecoveredAfterS">Time from a stall's end to the next current frame; the longest of the run.</param>
sealed record LinkResult(
    string Profile, int Seed, int Frames, double? CurrentAfterS, double? CoarseAfterS, double? SynchronisedAfterS,
    double? CurrentShare, double? LongestNotCurrentS, double? Reduction, double? HoldRmsMm, double? RmsMm, double? P95Mm,
    double? ClockErrorUsP50, double? ClockErrorUsP99, double? ClockErrorUsMax, double? StatedErrorUsP50, double? WithinStatedShare,
    double? HeldAfterS, double? RecoveredAfterS)
{
    /// <summary>True error of the offset that <c>headset --json</c> states at its end.</summary>
    public double? FinalClockErrorUs { get; init; }

    /// <summary>The uncertainty that <c>headset --json</c> states for this offset.</summary>
    public double? FinalStatedErrorUs { get; init; }

    /// <summary>Packets that entered the link, in both directions.</summary>
    public int Packets { get; init; }

    public int LostPackets { get; init; }

    /// <summary>Delay of packets by the emulator, which increases with other load on the machine.</summary>
    public double ReleaseLateUsP99 { get; init; }

    /// <summary>Delay of the headset's frames, which also increases with other load.</summary>
    public double FrameLateMsP99 { get; init; }

    /// <inheritdoc cref="ReleaseLateUsP99"/>
    public double ReleaseLateUsMax { get; init; }
}
