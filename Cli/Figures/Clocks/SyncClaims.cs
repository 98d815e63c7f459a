using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>The claims of Fig. 8 for exchanges whose true offset is unknown: errors are relative to the fit.</summary>
static class SyncClaims
{
    const double MaxFitErrorMs = 1;

    /// <summary>Minimum number of exchanges after the clock has settled.</summary>
    const int MinExchanges = 20;

    const string FitError = "From 10 s on, the fitting error |ε| of at least half of the exchanges is below 1 ms (median).";
    const string Skew = "In the last quarter, the skew varies less than half as much as from 2 to 10 s (RMS about the mean of the last quarter).";
    const string RoundTrip = "|ε| of the quarter with the shortest round trips is less than half of that of the quarter with the longest (P95).";

    public static IReadOnlyList<Criterion> Of(IReadOnlyList<SyncStep> steps)
    {
        var known = steps.Where(step => step.FitErrorMs.HasValue).ToArray();
        var settled = known.Where(step => step.Seconds >= ClockErrors.SettledAfter).ToArray();
        return settled.Length >= MinExchanges ? [FitErrorOf(settled), SkewOf(known), RoundTripOf(settled)]
            : [.. new[] { FitError, Skew, RoundTrip }.Select(statement =>
                new Criterion(statement, false, $"{settled.Length} usable exchanges after 10 s; {MinExchanges} are needed"))];
    }

    static Criterion FitErrorOf(SyncStep[] settled)
    {
        var median = Quantile.Of(settled.Select(step => Math.Abs(step.FitErrorMs.Value)), 0.5);
        return new(FitError, median < MaxFitErrorMs, $"{Text(1000 * median)} µs");
    }

    static Criterion SkewOf(SyncStep[] known)
    {
        var late = known.Where(step => step.Seconds >= 0.75 * known[^1].Seconds).Select(step => step.SkewPpm.Value).ToArray();
        var early = known.Where(step => step.Seconds is >= ClockErrors.FirstSkew and < ClockErrors.SettledAfter).Select(step => step.SkewPpm.Value).ToArray();
        if (early.Length == 0) return new(Skew, false, "the skew was first estimated after 10 s");
        var mean = late.Average();
        double Rms(double[] skews) => Math.Sqrt(skews.Average(skew => (skew - mean) * (skew - mean)));
        return new(Skew, 2 * Rms(late) < Rms(early), $"{Text(Rms(early))} ppm, then {Text(Rms(late))} ppm");
    }

    static Criterion RoundTripOf(SyncStep[] settled)
    {
        var trips = RoundTrips.Of(settled.Select(step => (step.RoundTripMs, 1000 * Math.Abs(step.FitErrorMs.Value))));
        return new(RoundTrip, 2 * trips.ShortUs < trips.LongUs, $"{Text(trips.ShortUs)} µs against {Text(trips.LongUs)} µs");
    }
}
