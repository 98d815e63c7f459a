using System.Globalization;

namespace Nowpose.Gateway.Status;

/// <summary>
/// State of one joint, frame or signal, from the diagnostics of its adapter. The diagnostics have the key KIND/NAME with the value
/// "STATE SINCE REASON". A joint that may not be at rest also has the key uncertain/NAME with the reason, and a joint that is neither live nor at rest
/// the key reason/NAME with one word.
/// </summary>
/// <param name="Since">Start of the state on the gateway's wall clock.</param>
/// <param name="Uncertainty">The reason why a joint reported at rest may not be at rest; empty if there is none.</param>
/// <param name="Word">The adapter's word for the reason; null if it sends none.</param>
readonly record struct AdapterReport(JointDataState State, DateTimeOffset Since, string Reason, string Uncertainty = "", string Word = null)
{
    public const string JointPrefix = "joint/";
    public const string FramePrefix = "frame/";
    public const string SignalPrefix = "signal/";
    public const string UncertainPrefix = "uncertain/";
    public const string WordPrefix = "reason/";

    /// <summary>
    /// The prefix that older adapters use in place of <see cref="UncertainPrefix"/>. Version 0.2 accepts it; the next release ignores it.
    /// </summary>
    public const string FormerUncertainPrefix = "doubt/";

    const int MaxReasonLength = 300;

    // End of the year 9999, the maximum of DateTimeOffset.
    const double MaxUnixSeconds = 253_402_300_799;

    // Two reports whose starts differ by less than this describe the same state. The transmission time causes the difference.
    static readonly TimeSpan SameSince = TimeSpan.FromSeconds(2);

    static readonly string[] Prefixes = [JointPrefix, FramePrefix, SignalPrefix, WordPrefix, UncertainPrefix, FormerUncertainPrefix];

    /// <summary>Time for which a report is valid. Adapters report once per second.</summary>
    public static readonly TimeSpan Validity = TimeSpan.FromSeconds(2.5);

    public static bool IsKey(string key) => Array.Exists(Prefixes, prefix => key.StartsWith(prefix, StringComparison.Ordinal));

    /// <summary>Returns the joint of a key uncertain/NAME, or of the former key doubt/NAME; null for another key.</summary>
    public static string UncertainJoint(string key)
    {
        if (key.StartsWith(UncertainPrefix, StringComparison.Ordinal)) return key[UncertainPrefix.Length..];
        return IsFormerKey(key) ? key[FormerUncertainPrefix.Length..] : null;
    }

    public static bool IsFormerKey(string key) => key.StartsWith(FormerUncertainPrefix, StringComparison.Ordinal);

    /// <summary>Parses a report.</summary>
    /// <param name="sent">Stamp of the message on the wall clock of the adapter's machine, like SINCE; zero if unknown.</param>
    /// <param name="now">Arrival of the message.</param>
    public static bool TryParse(string value, ControlTime sent, DateTimeOffset now, out AdapterReport report)
    {
        report = default;
        var words = value.Split(' ', 3);
        if (words.Length < 2 || !JointDataStates.TryRead(words[0], out var state)) return false;
        // Refuses the state stale, which only the gateway determines.
        if (state == JointDataState.Stale) return false;
        var isNumber = double.TryParse(words[1], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var seconds);
        if (!isNumber || seconds is not (>= 0 and <= MaxUnixSeconds)) return false;
        var reason = words.Length == 3 ? Sentence(words[2]) : "";
        // Uses only a difference of times of the same clock, because the clock of the adapter's machine may be wrong. Ignores the transmission time.
        var arrival = now - DateTimeOffset.UnixEpoch;
        var age = (sent == default ? arrival : sent.SinceEpoch) - TimeSpan.FromSeconds(seconds);
        report = new AdapterReport(state, now - Clamp(age, TimeSpan.Zero, arrival), reason);
        return true;
    }

    /// <summary>Returns this report with the start of the previous report if both describe the same state.</summary>
    public AdapterReport After(in AdapterReport previous) =>
        State == previous.State && (Since - previous.Since).Duration() < SameSince ? this with { Since = previous.Since } : this;

    static TimeSpan Clamp(TimeSpan value, TimeSpan min, TimeSpan max) => value < min ? min : value > max ? max : value;

    public static string Sentence(string text) => InputException.OneLine(text.Trim(), MaxReasonLength);
}
