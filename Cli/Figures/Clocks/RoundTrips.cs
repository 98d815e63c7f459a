using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Compares the errors of exchanges with short and with long round-trip times.</summary>
/// <param name="ShortUs">P95 of the offset error in the quarter of exchanges with the shortest round-trip times, µs.</param>
/// <param name="LongUs">P95 of the offset error in the quarter of exchanges with the longest round-trip times, µs.</param>
sealed record RoundTrips(double ShortUs, double LongUs)
{
    public static RoundTrips Of(IEnumerable<SimulatedExchanges> logs) =>
        Of(logs.SelectMany(log => log.All.Select(each => (each.RoundTripTime.TotalMilliseconds, ErrorUs(log, each)))));

    /// <param name="exchanges">Round-trip time and absolute offset error of each exchange; four exchanges or more.</param>
    public static RoundTrips Of(IEnumerable<(double RoundTripMs, double ErrorUs)> exchanges)
    {
        var byLength = exchanges.OrderBy(e => e.RoundTripMs).Select(e => e.ErrorUs).ToArray();
        var quarter = byLength.Length / 4;
        return new RoundTrips(Quantile.Of(byLength[..quarter], 0.95), Quantile.Of(byLength[^quarter..], 0.95));
    }

    static double ErrorUs(SimulatedExchanges log, in SyncExchange exchange) =>
        Math.Abs((exchange.Offset - log.TrueOffset(exchange.T4)).TotalMicroseconds);
}
