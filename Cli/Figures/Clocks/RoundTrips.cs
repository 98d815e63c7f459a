using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Whether the round-trip time tells a good exchange from a bad one.</summary>
/// <param name="ShortUs">P95 of the offset error of a single exchange among the quarter with the shortest round trips, µs.</param>
/// <param name="LongUs">The same among the quarter with the longest.</param>
sealed record RoundTrips(double ShortUs, double LongUs)
{
    public static RoundTrips Of(IEnumerable<SimulatedExchanges> logs)
    {
        var byLength = logs.SelectMany(log => log.All.Select(each => (each.RoundTripTime, Error: ErrorUs(log, each))))
            .OrderBy(e => e.RoundTripTime).Select(e => e.Error).ToArray();
        var quarter = byLength.Length / 4;
        return new RoundTrips(Quantile.Of(byLength[..quarter], 0.95), Quantile.Of(byLength[^quarter..], 0.95));
    }

    static double ErrorUs(SimulatedExchanges log, in SyncExchange exchange) =>
        Math.Abs((exchange.Offset - log.TrueOffset(exchange.T4)).TotalMicroseconds);
}
