namespace Nowpose.Benchmarks.Links;

/// <summary>Delay, jitter, loss and stalls of a packet link, the same in both directions.</summary>
/// <remarks>
/// Describes individual packets; the effect of a lost packet depends on the TCP implementation. <see cref="Simulation.NetworkProfile"/> describes
/// the delays of a byte stream instead.
/// </remarks>
sealed class LinkProfile
{
    /// <summary>Wired network of a cell.</summary>
    public static readonly LinkProfile Clean = new("clean", 1, 0.2, 0);

    /// <summary>Good WiFi.</summary>
    public static readonly LinkProfile Wifi = new("wifi", 2, 4, 0.002);

    /// <summary>WiFi at the edge of its range.</summary>
    public static readonly LinkProfile Lossy = new("lossy", 3, 6, 0.02);

    /// <summary>Private 5G or LTE network.</summary>
    public static readonly LinkProfile Cellular = new("cellular", 14, 3, 0);

    /// <summary>Crowded channel with a weak signal.</summary>
    public static readonly LinkProfile Bad = new("bad", 5, 12, 0.05);

    /// <summary>Headset that changes its access point every 8 s and has no link for 1.5 s each time.</summary>
    public static readonly LinkProfile Roaming = new("roaming", 3, 5, 0, stallIntervalSeconds: 8, stallSeconds: 1.5);

    public static readonly IReadOnlyList<LinkProfile> All = [Clean, Wifi, Lossy, Cellular, Bad, Roaming];

    LinkProfile(string name, double baseMs, double meanJitterMs, double loss, double stallIntervalSeconds = 0, double stallSeconds = 0)
    {
        Name = name;
        BaseMs = baseMs;
        MeanJitterMs = meanJitterMs;
        Loss = loss;
        StallInterval = ClockTicks.Span(stallIntervalSeconds);
        StallLength = ClockTicks.Span(stallSeconds);
    }

    public string Name { get; }

    /// <summary>Minimum one-way delay, ms.</summary>
    public double BaseMs { get; }

    /// <summary>Mean of the exponentially distributed delay in addition to <see cref="BaseMs"/>, ms.</summary>
    public double MeanJitterMs { get; }

    /// <summary>Probability that a packet is lost, 0 to 1.</summary>
    public double Loss { get; }

    /// <summary>
    /// Interval between the starts of two stalls, and from the link's start to the first stall; zero if the link never stalls.
    /// </summary>
    public TimeSpan StallInterval { get; }

    /// <summary>
    /// Duration of a stall. Both directions stall at the same time. Packets are not lost; they arrive after the end of the stall.
    /// </summary>
    public TimeSpan StallLength { get; }

    /// <summary>Returns the end of the stall at a given time, or the time itself if the link is not stalled.</summary>
    /// <param name="sinceStart">Time since the link's start.</param>
    public TimeSpan EndOfStall(TimeSpan sinceStart)
    {
        if (StallInterval == TimeSpan.Zero || sinceStart < StallInterval) return sinceStart;
        var intoStall = new TimeSpan(sinceStart.Ticks % StallInterval.Ticks);
        return intoStall < StallLength ? sinceStart - intoStall + StallLength : sinceStart;
    }

    /// <exception cref="InputException">No profile has that name.</exception>
    public static LinkProfile Named(string name) =>
        All.FirstOrDefault(profile => profile.Name == name)
        ?? throw new InputException($"link profile: '{name}' is unknown; allowed: {string.Join(", ", All.Select(p => p.Name))}");
}
