using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Judges the claims of Fig. 8 for exchanges whose true offset is unknown. Errors are relative to the fit.</summary>
static class SyncClaims
{
    /// <summary>Minimum number of exchanges after the clock has settled.</summary>
    const int MinExchanges = 20;

    const string Skew = Figure08Texts.SkewConverges;
    const string RoundTrip = Figure08Texts.ShortRoundTrips;

    public static IReadOnlyList<Criterion> Of(IReadOnlyList<SyncStep> steps)
    {
        var known = steps.Where(step => step.FitErrorMs.HasValue).ToArray();
        var settled = known.Where(step => step.Seconds >= ClockErrors.SettledAfter).ToArray();
        return settled.Length >= MinExchanges ? [FitErrorOf(settled), SkewOf(known), RoundTripOf(settled)]
            : [.. new[] { FitErrors.Claim, Skew, RoundTrip }.Select(statement =>
                new Criterion(statement, null, Figure08Texts.TooFewExchanges(settled.Length, MinExchanges)))];
    }

    static Criterion FitErrorOf(SyncStep[] settled)
    {
        var errors = FitErrors.Of(settled);
        var share = FitErrors.ShareBelow(errors);
        return new(FitErrors.Claim, share >= FitErrors.MinShare, $"{Percent(share)}; median {Text(1000 * Quantile.Of(errors, 0.5))} µs");
    }

    // The second condition rejects a skew that still changes at a constant rate. Such a skew varies little within the last quarter, but its mean
    // changes between the third and the last quarter. The change must be less than a quarter of the RMS difference between the early values and
    // the mean of the last quarter.
    static Criterion SkewOf(SyncStep[] known)
    {
        var end = known[^1].Seconds;
        double[] Between(double from, double to) => [.. known.Where(step => step.Seconds >= from && step.Seconds < to).Select(step => step.SkewPpm.Value)];
        var (early, third, last) = (Between(ClockErrors.FirstSkew, ClockErrors.SettledAfter), Between(end / 2, 0.75 * end), Between(0.75 * end, double.MaxValue));
        if (early.Length == 0) return new(Skew, null, Figure08Texts.LateSkew);
        if (third.Length == 0) return new(Skew, null, Figure08Texts.NoExchange);
        var mean = last.Average();
        double Rms(double[] skews) => Math.Sqrt(skews.Average(skew => (skew - mean) * (skew - mean)));
        var change = Math.Abs(mean - third.Average());
        return new(Skew, 2 * Rms(last) < Rms(early) && 4 * change < Rms(early),
            Figure08Texts.SkewMeasured(Text(Rms(early)), Text(Rms(last)), Text(change)));
    }

    static Criterion RoundTripOf(SyncStep[] settled)
    {
        var trips = RoundTrips.Of(settled.Select(step => (step.RoundTripMs, 1000 * Math.Abs(step.FitErrorMs.Value))));
        return new(RoundTrip, 2 * trips.ShortUs < trips.LongUs, $"{Text(trips.ShortUs)} µs against {Text(trips.LongUs)} µs");
    }
}
