namespace Nowpose.Gateway.Messages;

/// <summary>Messages about time stamps that contradict the control clock, with remedies.</summary>
static class StampMessages
{
    // Offsets of time zones are multiples of 15 minutes, up to 14 hours.
    static readonly TimeSpan QuarterHour = TimeSpan.FromMinutes(15);
    const int MaxZoneQuarters = 14 * 4;

    // Since 2017. UTC has had no leap second since then.
    static readonly TimeSpan TaiMinusUtc = TimeSpan.FromSeconds(37);
    static readonly TimeSpan GpsMinusUtc = TimeSpan.FromSeconds(18);

    static readonly TimeSpan Tolerance = TimeSpan.FromSeconds(2);

    public const string AgreeAgain = "clock: time stamps and control clock agree again";

    public static string Log(string warning) => $"clock: {warning}";
    public static string NotFollowing(string clock) => $"they do not follow the control clock {clock}";

    public const string NotCorrected = "they did not follow a correction of the system clock";
    public const string Corrected = "they follow the system clock, which has moved relative to the control clock";
    /// <summary>The remedy for a source whose clock is not the control clock.</summary>
    public const string SourceRemedy = "Set the clock of the source, or let its adapter offer the clock that stamps its values.";
    /// <summary>The remedy for a source whose samples are too old, because of its clock or because they arrive late.</summary>
    public const string LateSourceRemedy =
        "Set the clock that stamps the values. If it is right, reduce the delay of the samples on their way to the gateway.";

    /// <summary>The remedy for a gateway with its own clock; does not apply to the command simulate.</summary>
    public const string SystemRemedy = "Restart the gateway. With serve --own-clock system, it follows the system clock.";

    public const string FitsSystemClock = ", and that match the system clock";

    public static string SystemClockCorrected(double seconds) =>
        FormattableString.Invariant($"the system clock has moved by {seconds:+0.0;-0.0} s relative to the control clock since the gateway started. ")
        + "Time stamps that a source takes from the system clock are wrong by this amount";

    /// <returns>The end of a sentence about one source, which names the other sources; empty if there are none.</returns>
    public static string SameFor(IReadOnlyCollection<string> sources) =>
        sources.Count == 0 ? "" : $"; the same is true of {string.Join(", ", sources)}";

    public static string Shifted(string source, string length, bool isOlder, bool isSystemServed, string cause) =>
        $"the stamps of the source {source} became {length} {(isOlder ? "older" : "newer")} relative to the control clock"
        + $"{(isSystemServed ? "" : ", but not relative to the system clock")}: {cause}";

    public static string Implausible(string source, double percent, string length, bool isFuture) => FormattableString.Invariant(
        $"{percent:0} % of the samples of the source {source} have stamps that are {length} {(isFuture ? "ahead of" : "behind")} the control clock");

    /// <summary>The remedy for a source, with the probable cause of a difference that is typical of another time scale.</summary>
    /// <param name="age">Control time minus the stamp.</param>
    public static string SourceRemedyFor(TimeSpan age)
    {
        var quarters = Math.Round(age.Duration() / QuarterHour);
        return SourceRemedy + (
            IsNear(age, -TaiMinusUtc) ? " The source probably sends TAI instead of UTC."
            : IsNear(age, -GpsMinusUtc) ? " The source probably sends GPS time instead of UTC."
            : quarters is >= 1 and <= MaxZoneQuarters && IsNear(age.Duration(), quarters * QuarterHour) ? " The source probably sends local time instead of UTC."
            : "");
    }

    static bool IsNear(TimeSpan length, TimeSpan typical) => (length - typical).Duration() <= Tolerance;
}
