using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Shows whether the round-trip time distinguishes good exchanges from bad ones.</summary>
/// <param name="ShortUs">P95 of the offset error of single exchanges in the quarter with the shortest round-trip times, µs.</param>
/// <param name="LongUs">The same in the quarter with the longest round-trip times, µs.</param>
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
