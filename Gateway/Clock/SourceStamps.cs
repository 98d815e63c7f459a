namespace Nowpose.Gateway.Clock;

/// <summary>Counts the samples of one source in the last seconds by how their stamps fit the clocks. Used by one thread at a time.</summary>
sealed class SourceStamps
{
    readonly Second[] _seconds = new Second[StampWatch.Seconds];
    long? _first;

    /// <param name="now">Number of the present second.</param>
    /// <param name="age">Control time minus the stamp.</param>
    /// <param name="isAhead">Whether the stamp lies further in the future than the clocks explain.</param>
    public void Add(long now, TimeSpan age, bool isRefused, bool fitsSystem, bool isAhead)
    {
        _first ??= now;
        ref var second = ref _seconds[now % StampWatch.Seconds];
        if (second.Number != now) second = new Second { Number = now };
        second.Samples++;
        if (isRefused) second.Refused++;
        if (fitsSystem) second.OnSystem++;
        if (isAhead) second.Ahead++;
        if (isRefused || fitsSystem || isAhead) second.Age = age;
    }

    /// <summary>Sums up the seconds that are not older than <see cref="StampWatch.Seconds"/>.</summary>
    public StampCounts Read(long now)
    {
        var recent = Array.FindAll(_seconds, second => second.Samples > 0 && second.Number > now - StampWatch.Seconds);
        return new StampCounts(
            recent.Sum(second => second.Samples), recent.Sum(second => second.Refused), recent.Sum(second => second.OnSystem),
            recent.Sum(second => second.Ahead), now - _first >= StampWatch.Seconds,
            recent.OrderBy(second => second.Number).LastOrDefault(second => second.Age != TimeSpan.Zero).Age);
    }

    struct Second
    {
        public long Number;
        public int Samples, Refused, OnSystem, Ahead;
        public TimeSpan Age;
    }
}

/// <param name="Refused">Samples that were refused because their stamps lie in the future.</param>
/// <param name="OnSystem">Samples that fit the system clock and not the control clock.</param>
/// <param name="Ahead">Samples whose stamps lie in the future, refused or not.</param>
/// <param name="IsLasting">Whether the source has sent samples for <see cref="StampWatch.Seconds"/> or longer.</param>
/// <param name="Age">Control time minus the newest of these stamps.</param>
readonly record struct StampCounts(int Samples, int Refused, int OnSystem, int Ahead, bool IsLasting, TimeSpan Age)
{
    public bool IsContradiction => Samples >= StampWatch.MinSamples && 2 * Math.Max(Refused, OnSystem) > Samples;
    public bool IsAhead => IsLasting && !IsContradiction && Samples >= StampWatch.MinSamples && 2 * Ahead > Samples;
    public bool FitsSystem => 2 * OnSystem > Samples;
    public double Percent => 100.0 * Math.Max(Refused, OnSystem) / Samples;
}
