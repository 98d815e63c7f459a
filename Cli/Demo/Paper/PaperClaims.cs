using MathNet.Numerics.Distributions;
using MathNet.Numerics.Statistics;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>Judges the paper's claims of Figs 8, 16, 17 and 18 with the values measured in the runs.</summary>
static class PaperClaims
{
    const string Ms = "ms", Share = "share";
    const double Confidence = 0.975;

    static readonly PaperRule[] Rules =
    [
        new("8", FitErrors.Claim, 1, Share, m => m.Clock?.FitShare, share => share >= FitErrors.MinShare) { Min = 0, Max = 1 },
        new("8", PaperClaimTexts.Offset, null, Ms,
            m => m.Clock?.OffsetErrorMs, ms => ms < 1),
        new("8", PaperClaimTexts.Skew, null, Share,
            m => m.Clock?.SkewRatio, ratio => ratio < 0.5),
        new("8", PaperClaimTexts.RoundTrip, null, Share, m => m.Clock?.RoundTripRatio, ratio => ratio < 0.5),
        OfSwings("16", PaperClaimTexts.Follows, null, swings => swings.ErrorRatio, ratio => ratio < 0.5),
        OfSwings("16", PaperClaimTexts.CurvedPhases, null, swings => swings.SteadyRatio, ratio => ratio <= 1 / 1.5),
        GapAt(0, "A"), GapAt(1, "B"), GapAt(2, "C"),
        new("18", PaperClaimTexts.Latency, 4, Ms, m => m.LightErrorMs, ms => ms < 4),
        OfSwings("18", PaperClaimTexts.Reduction, 0.8,
            swings => swings.Reduction, reduction => reduction >= 0.75) with { Max = 1 },
        OfSwings("18", PaperClaimTexts.EffectiveLatency, null,
            swings => swings.LatencyRatio, ratio => ratio < 1 / 3.0),
    ];

    /// <param name="repeats">
    /// The complete repeats; empty if the first one was interrupted. A claim is judged by the mean over the repeats that measured its value, and by
    /// the confidence interval of the mean.
    /// </param>
    public static IReadOnlyList<PaperClaim> Of(IReadOnlyList<PaperMeasures> repeats) => [.. Rules.Select(rule => Judge(rule, repeats))];

    static PaperClaim Judge(PaperRule rule, IReadOnlyList<PaperMeasures> repeats)
    {
        double?[] measured = [.. repeats.Select(rule.Measure).Select(value => value is double number && double.IsFinite(number) ? value : null)];
        double[] values = [.. measured.OfType<double>()];
        if (values.Length == 0)
        {
            var reason = $"{Verdict.NotMeasured.Words()}: {ReasonOf(rule, repeats)}";
            return new(rule.Figure, rule.Claim, rule.Paper, null, null, rule.Unit, false) { NotMeasured = reason, Repeats = measured };
        }
        var mean = values.Average();
        double? uncertainty = values.Length < 2 ? null
            : StudentT.InvCDF(0, 1, values.Length - 1, Confidence) * values.StandardDeviation() / Math.Sqrt(values.Length);
        // Each rule has one limit, so all values of the interval meet it if both ends do.
        bool isMetBelow = rule.IsMet(mean - (uncertainty ?? 0)), isMetAbove = rule.IsMet(mean + (uncertainty ?? 0));
        return new(rule.Figure, rule.Claim, rule.Paper, mean, uncertainty, rule.Unit, isMetBelow && isMetAbove)
        {
            Repeats = measured,
            Min = rule.Min,
            Max = rule.Max,
            IsUndecided = isMetBelow != isMetAbove,
            NotMeasured = values.Length == repeats.Count ? null
                : PaperClaimTexts.NotInAll(values.Length, repeats.Count, ReasonOf(rule, repeats)),
        };
    }

    static string ReasonOf(PaperRule rule, IReadOnlyList<PaperMeasures> repeats)
    {
        if (repeats.Count == 0) return PaperClaimTexts.Interrupted;
        var repeat = repeats.First(each => !(rule.Measure(each) is double number && double.IsFinite(number)));
        return rule.NeedsSwings ? repeat.SwingProblem : repeat.ClockProblem;
    }

    static PaperRule GapAt(int moment, string name) => OfSwings(
        "17", PaperClaimTexts.Gap(name), null, swings => swings.GapRatios[moment], ratio => ratio < 0.5);

    static PaperRule OfSwings(string figure, string claim, double? paper, Func<PaperSwings, double> measure, Func<double, bool> isMet) =>
        new(figure, claim, paper, Share, repeat => repeat.Swings == null ? null : measure(repeat.Swings), isMet) { NeedsSwings = true };
}

/// <summary>A claim of the paper, with the functions that measure and judge it.</summary>
/// <param name="Measure">Gets the value of one repeat; null if it was not measured.</param>
/// <param name="IsMet">Decides whether a value meets the claim: all values up to a limit, or all values from a limit on.</param>
sealed record PaperRule(string Figure, string Claim, double? Paper, string Unit, Func<PaperMeasures, double?> Measure, Func<double, bool> IsMet)
{
    /// <summary>Whether the value is measured over whole swings.</summary>
    public bool NeedsSwings { get; init; }

    /// <inheritdoc cref="PaperClaim.Min"/>
    public double Min { get; init; } = double.NegativeInfinity;

    /// <inheritdoc cref="PaperClaim.Max"/>
    public double Max { get; init; } = double.PositiveInfinity;
}
