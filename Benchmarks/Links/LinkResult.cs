namespace Nowpose.Benchmarks.Links;

/// <summary>The result of one run over one link, compared with the true values. Missing values are null.</summary>
/// <param name="CurrentAfterS">Time from the first frame to the first frame with a current pose, s.</param>
/// <param name="CoarseAfterS">Time from the first frame to the first frame with a coarse or synchronised clock, s.</param>
/// <param name="CurrentShare">Share of frames with a current pose. This and all following values start with the first current frame.</param>
/// <param name="Reduction">1 minus the RMS error of the tool divided by the RMS error without compensation.</param>
/// <param name="ClockErrorUsP50">Error of the frames' control times.</param>
/// <param name="StatedErrorUsP50">Error of the clock as stated by the headset.</param>
/// <param name="WithinStatedShare">Share of frames whose clock error does not exceed the stated error.</param>
/// <param name="HeldAfterS">Longest time from the start of a stall to the first frame without a current pose.</param>
/// <param name="RecoveredAfterS">Longest time from the end of a stall to the next frame with a current pose.</param>
sealed record LinkResult(
    string Profile, int Seed, int Frames, double? CurrentAfterS, double? CoarseAfterS, double? SynchronisedAfterS,
    double? CurrentShare, double? LongestNotCurrentS, double? Reduction, double? HoldRmsMm, double? RmsMm, double? P95Mm,
    double? ClockErrorUsP50, double? ClockErrorUsP99, double? ClockErrorUsMax, double? StatedErrorUsP50, double? WithinStatedShare,
    double? HeldAfterS, double? RecoveredAfterS)
{
    /// <summary>True error of the offset that <c>headset --json</c> prints at its end.</summary>
    public double? FinalClockErrorUs { get; init; }

    /// <summary>Error that <c>headset --json</c> states for this offset.</summary>
    public double? FinalStatedErrorUs { get; init; }

    /// <summary>Number of packets that entered the link in both directions.</summary>
    public int Packets { get; init; }

    public int LostPackets { get; init; }

    /// <summary>P99 of the time by which the emulator released packets too late. Other load on the machine increases it.</summary>
    public double ReleaseLateUsP99 { get; init; }

    /// <summary>P99 of the time by which the headset's frames were late. Other load on the machine increases it.</summary>
    public double FrameLateMsP99 { get; init; }

    /// <summary>Maximum time by which the emulator released a packet too late. Other load on the machine increases it.</summary>
    public double ReleaseLateUsMax { get; init; }
}
