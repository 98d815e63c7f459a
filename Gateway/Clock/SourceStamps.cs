namespace Nowpose.Gateway.Clock;

/// <summary>Counts the samples of one source in the last few seconds, by how well their stamps match the clocks. Not thread-safe.</summary>
sealed class SourceStamps
{
    readonly Second[] _seconds = new Second[StampWatch.Seconds];
    long? _first;

    /// <summary>
    /// Minimum ages of the samples in the first <see cref="StampWatch.Seconds"/> consecutive seconds in which all stamps were plausible and neither
    /// clock was corrected; null before. They are the reference for later samples.
    /// </summary>
    public MinAges? Usual { get; set; }

    /// <param name="now">Number of the current second.</param>
    /// <param name="age">Control time minus the stamp.</param>
    /// <param name="otherAge">Time of the other clock of <see cref="StampWatch"/> minus the stamp.</param>
    /// <param name="isRefused">Whether the sample was refused because its stamp lies in the future.</param>
    /// <param name="fitsOther">Whether the stamp matches the other clock but not the control clock.</param>
    /// <param name="isAhead">Whether the stamp is further in the future than the clocks' errors explain.</param>
    /// <param name="isBehind">Whether the sample is too old to be displayed.</param>
    public void Add(
        long now, ControlTime stamp, TimeSpan age, TimeSpan otherAge, bool isRefused, bool fitsOther, bool isAhead, bool isBehind)
    {
        _first ??= now;
        ref var second = ref _seconds[now % StampWatch.Seconds];
        if (second.Samples == 0 || second.Number != now)
            second = new Second { Number = now, MinAges = new MinAges(TimeSpan.MaxValue, TimeSpan.MaxValue) };
        second.Samples++;
        second.MinAges = second.MinAges.With(new MinAges(age, otherAge));
        if (isRefused) second.Refused++;
        if (fitsOther) second.OnOther++;
        if (isAhead) second.Ahead++;
        if (isBehind)
        {
            second.Behind++;
            if (stamp > second.NewestBehind) second.NewestBehind = stamp;
        }

        if (isRefused || fitsOther || isAhead || isBehind) second.Age = age;
    }

    /// <summary>Returns the totals of the last <see cref="StampWatch.Seconds"/> seconds.</summary>
    /// <param name="isCorrected">Whether one clock has been corrected relative to the other. Current stamps are then not a valid reference.</param>
    public StampCounts Read(long now, bool isCorrected)
    {
        Second[] recent =
            [.. _seconds.Where(second => second.Samples > 0 && second.Number > now - StampWatch.Seconds).OrderBy(second => second.Number)];
        var isLasting = now - _first >= StampWatch.Seconds;
        if (!isCorrected && recent.Length == StampWatch.Seconds && recent.All(second => second.IsPlausible)
            && MinAges.Agree(recent.Select(second => second.MinAges)))
            Usual ??= recent.Select(second => second.MinAges).Aggregate((one, other) => one.With(other));
        var shift = Usual is { } usual && recent.Length > 0 ? recent[^1].MinAges.ShiftWithOther(usual) : TimeSpan.Zero;
        return new StampCounts(
            recent.Sum(second => second.Samples), recent.Sum(second => second.Refused), recent.Sum(second => second.OnOther),
            recent.Sum(second => second.Ahead), AreOld(Array.FindAll(recent, second => second.Number < now)), isLasting, shift,
            recent.LastOrDefault(second => second.Age != TimeSpan.Zero).Age);
    }

    // Each second must have a newer stamp among its old ones: samples that arrive late once, after a pause, have the stamps of one second only, and a
    // source may repeat the sample of a joint at rest.
    static bool AreOld(Second[] complete)
    {
        var newest = default(ControlTime);
        foreach (var second in complete)
        {
            if (2 * second.Behind <= second.Samples || second.NewestBehind <= newest) return false;
            newest = second.NewestBehind;
        }

        return complete.Length == StampWatch.Seconds - 1;
    }

    struct Second
    {
        public long Number;
        public int Samples, Refused, OnOther, Ahead, Behind;
        public TimeSpan Age;
        public ControlTime NewestBehind;
        public MinAges MinAges;

        public readonly bool IsPlausible => Refused == 0 && OnOther == 0 && Ahead == 0;
    }
}

/// <summary>The minimum ages of a source's samples in an interval, on the control clock and on the other clock of <see cref="StampWatch"/>.</summary>
readonly record struct MinAges(TimeSpan Control, TimeSpan Other)
{
    /// <summary>Maximum change of the difference between the two ages while neither clock is corrected.</summary>
    static readonly TimeSpan MaxDifference = TimeSpan.FromMilliseconds(20);

    TimeSpan Ahead => Control - Other;

    public MinAges With(MinAges other) =>
        new(Control < other.Control ? Control : other.Control, Other < other.Other ? Other : other.Other);

    /// <summary>Whether neither clock was corrected in these intervals: the difference between the two ages is constant.</summary>
    public static bool Agree(IEnumerable<MinAges> all)
    {
        var ahead = all.Select(one => one.Ahead).ToArray();
        return ahead.Max() - ahead.Min() <= MaxDifference;
    }

    /// <summary>
    /// Gets the change of the age on the control clock, if the age on the other clock is unchanged; zero otherwise.
    /// </summary>
    public TimeSpan ShiftWithOther(MinAges usual)
    {
        var shift = Control - usual.Control;
        return shift.Duration() >= StampWatch.MinCorrection && (Other - usual.Other).Duration() <= shift.Duration() / 4 ? shift : TimeSpan.Zero;
    }
}

/// <param name="Refused">Samples that were refused because their stamps lie in the future.</param>
/// <param name="OnOther">Samples whose stamps match the other clock but not the control clock.</param>
/// <param name="Ahead">Samples whose stamps are in the future, refused or not.</param>
/// <param name="AreOld">Whether in each second, most samples were too old to be displayed, and their newest stamp was a new one.</param>
/// <param name="IsLasting">Whether the source has sent samples for <see cref="StampWatch.Seconds"/> or longer.</param>
/// <param name="Shift">
/// Change of the stamps' minimum age on the control clock after a correction of the system clock that only one of the two followed: the
/// stamps or the control clock. Positive when the stamps became older; zero without such a change.
/// </param>
/// <param name="Age">Control time minus the newest stamp that was refused, matched the other clock, lay in the future or was too old.</param>
readonly record struct StampCounts(int Samples, int Refused, int OnOther, int Ahead, bool AreOld, bool IsLasting, TimeSpan Shift, TimeSpan Age)
{
    public bool IsContradiction => IsImplausible || IsShifted;

    /// <summary>Whether most stamps are implausible for live samples on the control clock.</summary>
    public bool IsImplausible => Samples >= StampWatch.MinSamples && 2 * Math.Max(Refused, OnOther) > Samples;

    public bool IsShifted => Samples >= StampWatch.MinSamples && Shift != TimeSpan.Zero;
    public bool IsAhead => IsUsable && 2 * Ahead > Samples;
    public bool IsBehind => IsUsable && AreOld;
    public bool FitsOther => 2 * OnOther > Samples;
    bool IsUsable => IsLasting && !IsContradiction && Samples >= StampWatch.MinSamples;

    public double Percent => 100.0 * Math.Max(Refused, OnOther) / Samples;
}
