using Nowpose.Cli.Figures.Clocks;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>The measured values for Fig. 8.</summary>
/// <param name="FitShare">Share of the exchanges with |ε_i| below 1 ms, from 10 s on.</param>
/// <param name="OffsetErrorMs">P95 of the absolute error of the offset over the frames from 10 s on, ms.</param>
/// <param name="SkewRatio">RMS error of the skew over the last quarter divided by the RMS error from 2 to 10 s.</param>
/// <param name="RoundTripRatio">
/// P95 error of the quarter of exchanges with the shortest round-trip times divided by that of the quarter with the longest ones.
/// </param>
sealed record PaperClock(double FitShare, double OffsetErrorMs, double SkewRatio, double RoundTripRatio)
{
    const int MinExchanges = 4;

    /// <summary>Computes the values; null if the run was too short.</summary>
    public static PaperClock Of(PaperRun run)
    {
        var errors = FitErrors.Of(run.Steps);
        if (errors.Length < MinExchanges || run.Scored.Count == 0) return null;
        var known = run.Run.Frames.Rows.Where(row => row.Clock.IsKnown).ToList();
        var end = known[^1].Elapsed.TotalSeconds;
        return new PaperClock(
            FitErrors.ShareBelow(errors), Quantile.Of(run.Scored.Select(row => Math.Abs(row.OffsetErrorUs) / 1000), 0.95),
            SkewRms(run, known, 0.75 * end, end) / SkewRms(run, known, ClockErrors.FirstSkew, ClockErrors.SettledAfter), RoundTripRatioOf(run));
    }

    static double SkewRms(PaperRun run, List<DemoFrames.Row> rows, double from, double to)
    {
        var (first, last) = (rows[0].Start, rows[^1].Start);
        var trueSkew = (run.Run.Truth.OffsetAt(last) - run.Run.Truth.OffsetAt(first)) / (last - first);
        var squares = rows.Where(row => row.Elapsed.TotalSeconds >= from && row.Elapsed.TotalSeconds <= to)
            .Select(row => (row.Clock.Skew - trueSkew) * (row.Clock.Skew - trueSkew)).ToList();
        return squares.Count == 0 ? double.NaN : Math.Sqrt(squares.Average());
    }

    static double RoundTripRatioOf(PaperRun run)
    {
        var trips = RoundTrips.Of(run.Run.Exchanges.Select(each => ((each.T4 - each.T1).TotalMilliseconds, ErrorUs(run, each))));
        return trips.ShortUs / trips.LongUs;
    }

    static double ErrorUs(PaperRun run, in SyncExchange exchange) =>
        Math.Abs((exchange.Offset - run.Run.Truth.OffsetAt(exchange.T4)).TotalMicroseconds);
}
