using System.Globalization;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>State of one joint as its adapter reports it: the value STATE SINCE REASON of the key joint/NAME.</summary>
/// <param name="Since">Start of the state, on the wall clock of the adapter's machine.</param>
/// <param name="Uncertainty">The reason why it is uncertain that the joint rests, the value of the key uncertain/NAME; empty for none.</param>
readonly record struct AdapterJointReport(JointDataState State, DateTimeOffset Since, string Reason, string Uncertainty = "")
{
    public const string KeyPrefix = "joint/";
    public const string UncertainPrefix = "uncertain/";
    const int MaxReasonLength = 300;

    // The year 9999, the last one of DateTimeOffset.
    const double MaxUnixSeconds = 253_402_300_799;

    public static bool IsKey(string key) =>
        key.StartsWith(KeyPrefix, StringComparison.Ordinal) || key.StartsWith(UncertainPrefix, StringComparison.Ordinal);

    public static bool TryParse(string value, out AdapterJointReport report)
    {
        report = default;
        var words = value.Split(' ', 3);
        if (words.Length < 2 || !JointDataStates.TryRead(words[0], out var state)) return false;
        // Stale is determined by the gateway only, not by an adapter.
        if (state == JointDataState.Stale) return false;
        var isNumber = double.TryParse(words[1], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var seconds);
        if (!isNumber || seconds is not (>= 0 and <= MaxUnixSeconds)) return false;
        var reason = words.Length == 3 ? Sentence(words[2]) : "";
        report = new AdapterJointReport(state, DateTimeOffset.UnixEpoch + TimeSpan.FromSeconds(seconds), reason);
        return true;
    }

    public static string Sentence(string text) => InputException.OneLine(text.Trim(), MaxReasonLength);
}
