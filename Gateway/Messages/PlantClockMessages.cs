using Nowpose.Sync;

namespace Nowpose.Gateway.Messages;

/// <summary>States and comparisons of the control clock and of the plants' clocks, for the log.</summary>
static class PlantClockMessages
{
    public static string NotCompared(string reason) => $"clock: the clocks could not be compared ({reason})";

    public static string Compared(string clock, double aheadMs, double boundMs, string source, double? skewPpm) =>
        FormattableString.Invariant($"clock '{clock}': {aheadMs:+0.00;-0.00;0.00} ms (± {boundMs:0.00}) against '{source}', skew ")
        + FormattableString.Invariant($"{skewPpm:+0.0;-0.0;0.0} ppm");

    public static string ExchangeUnusable(SyncExchangeFault fault) => $"the exchange cannot be used: {fault}";

    public static string NoResponse(double seconds) => FormattableString.Invariant($"no response within {seconds} s");
    public const string NoTime = "the adapter's response contains no time";

    public static string State(string clock, string state, bool isControlClock) =>
        isControlClock ? $"clock '{clock}': {state}; it is the control clock" : $"clock '{clock}': {state}";
}
