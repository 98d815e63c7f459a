namespace Nowpose.Gateway.Clock;

/// <summary>Counts the samples of one source in the last seconds by how their stamps match the clocks. For one thread at a time.</summary>
sealed class SourceStamps
{
    readonly Second[] _seconds = new Second[StampWatch.Seconds];
    long? _first;

    /// <summary>Minimum ages of the first seconds, with which later ones are compared; null until there are enough samples.</summary>
    public MinAges? Usual { get; set; }

    /// <param name="now">Number of the current second.</param>
    /// <param name="age">Control time minus the stamp.</param>
    /// <param name="systemAge">System time minus the stamp.</param>
    /// <param name="isAhead">Whether the stamp is further in the future than the clocks' errors explain.</param>
    public void Add(long now, TimeSpan age, TimeSpan systemAge, bool isRefused, bool fitsSystem, bool isAhead)
    {
        _first ??= now;
        ref var second = ref _seconds[now % StampWatch.Seconds];
        if (second.Samples == 0 || second.Number != now)
            second = new Second { Number = now, MinAges = new MinAges(TimeSpan.MaxValue, TimeSpan.MaxValue) };
        second.Samples++;
        second.MinAges = second.MinAges.With(new MinAges(age, systemAge));
        if (isRefused) second.Refused++;
        if (fitsSystem) second.OnSystem++;
        if (isAhead) second.Ahead++;
        if (isRefused || fitsSystem || isAhead) second.Age = age;
    }

    /// <summary>Sums up the seconds within <see cref="StampWatch.Seconds"/>.</summary>
    /// <param name="isCorrected">Whether the clocks have been corrected against each other, so that current stamps are not a valid reference.</param>
    public StampCounts Read(long now, bool isCorrected)
    {
        var recent = Array.FindAll(_seconds, second => second.Samples > 0 && second.Number > now - StampWatch.Seconds);
        var isLasting = now - _first >= StampWatch.Seconds;
        if (!isCorrected && recent.Length == StampWatch.Seconds && recent.All(second => second.IsPlausible)
            && MinAges.Agree(recent.Select(second => second.MinAges)))
            Usual ??= recent.Select(second => second.MinAges).Aggregate((one, other) => one.With(other));
        var shift = Usual is { } usual && recent.Length > 0 ? recent.MaxBy(second => second.Number).MinAges.ShiftWithSystem(usual) : TimeSpan.Zero;
        return new StampCounts(
            recent.Sum(second => second.Samples), recent.Sum(second => second.Refused), recent.Sum(second => second.OnSystem),
            recent.Sum(second => second.Ahead), isLasting, shift,
            recent.OrderBy(second => second.Number).LastOrDefault(second => second.Age != TimeSpan.Zero).Age);
    }

    struct Second
    {
        public long Number;
        public int Samples, Refused, OnSystem, Ahead;
        public TimeSpan Age;
        public MinAges MinAges;

        public readonly bool IsPlausible => Refused == 0 && OnSystem == 0 && Ahead == 0;
    }
}

/// <summary>The minimum ages of a source's samples in an interval, by the control clock and by the system clock.</summary>
readonly record struct MinAges(TimeSpan Control, TimeSpan System)
{
    /// <summary>Maximum change of the difference of the ages if neither clock was corrected.</summary>
    static readonly TimeSpan MaxDifference = TimeSpan.FromMilliseconds(20);

    TimeSpan Ahead => Control - System;

    public MinAges With(MinAges other) =>
        new(Control < other.Control ? Control : other.Control, System < other.System ? System : other.System);

    /// <summary>Whether neither clock was corrected in the interval.</summary>
    public static bool Agree(IEnumerable<MinAges> all)
    {
        var ahead = all.Select(one => one.Ahead).ToArray();
        return ahead.Max() - ahead.Min() <= MaxDifference;
    }

    /// <summary>
    /// Gets the change of the ages by the control clock, if the ages by the system clock are unchanged; zero otherwise.
    /// </summary>
    public TimeSpan ShiftWithSystem(MinAges usual)
    {
        var shift = Control - usual.Control;
        return shift.Duration() >= StampWatch.MinCorrection && (System - usual.System).Duration() <= shift.Duration() / 4 ? shift : TimeSpan.Zero;
    }
}

/// <param name="Refused">Samples that were refused because their stamps lie in the future.</param>
/// <param name="OnSystem">Samples whose stamps match the system clock but not the control clock.</param>
/// <param name="Ahead">Samples whose stamps are in the future, refused or not.</param>
/// <param name="IsLasting">Whether the source has sent samples for <see cref="StampWatch.Seconds"/> or longer.</param>
/// <param name="Shift">
/// Change of the stamps' ages after a correction of the system clock that they followed, at plausible ages; positive when they became older.
/// </param>
/// <param name="Age">Control time minus the newest of these stamps.</param>
readonly record struct StampCounts(int Samples, int Refused, int OnSystem, int Ahead, bool IsLasting, TimeSpan Shift, TimeSpan Age)
{
    public bool IsContradiction => IsImplausible || IsShifted;

    /// <summary>Whether most stamps cannot belong to live samples.</summary>
    public bool IsImplausible => Samples >= StampWatch.MinSamples && 2 * Math.Max(Refused, OnSystem) > Samples;

    public bool IsShifted => Samples >= StampWatch.MinSamples && Shift != TimeSpan.Zero;
    public bool IsAhead => IsLasting && !IsContradiction && Samples >= StampWatch.MinSamples && 2 * Ahead > Samples;
    public bool FitsSystem => 2 * OnSystem > Samples;
    public double Percent => 100.0 * Math.Max(Refused, OnSystem) / Samples;
}
