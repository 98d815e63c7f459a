using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>The fitting errors ε_i of Eq. (6) after the clock has settled. The paper achieves |ε_i| below 1 ms.</summary>
static class FitErrors
{
    /// <summary>Bound of the paper, ms.</summary>
    public const double BoundMs = 1;

    /// <summary>Minimum share of the exchanges below the bound. The others are the outliers that RANSAC excludes.</summary>
    public const double MinShare = 0.95;

    public const string Claim = Figure08Texts.FittingError;

    /// <summary>Gets |ε_i| of the exchanges from <see cref="ClockErrors.SettledAfter"/> on, ms.</summary>
    public static double[] Of(IEnumerable<SyncStep> steps) =>
        [.. steps.Where(step => step.Seconds >= ClockErrors.SettledAfter && step.FitErrorMs.HasValue).Select(step => Math.Abs(step.FitErrorMs.Value))];

    /// <summary>Gets the same with the true offset instead of the fit: the errors of the exchanges themselves, which no estimator removes.</summary>
    /// <param name="first">Φ* of the first exchange, to which the steps are relative.</param>
    /// <param name="truth">Φ at a headset time.</param>
    public static double[] OfExchanges(IEnumerable<SyncStep> steps, ClockOffset first, Func<HeadsetTime, ClockOffset> truth) =>
        Of(steps.Select(step => step with { FitMs = (truth(step.At) - first).TotalMilliseconds }));

    /// <summary>States the share of the exchanges that are below the bound with the true offset.</summary>
    public static string TextOfExchanges(double[] errors) => errors.Length == 0 ? ""
        : Figure08Texts.ExchangeErrors(Numbers.Percent(ShareBelow(errors)), BoundMs);

    /// <param name="errors">At least one error.</param>
    public static double ShareBelow(double[] errors) => (double)errors.Count(ms => ms < BoundMs) / errors.Length;
}
