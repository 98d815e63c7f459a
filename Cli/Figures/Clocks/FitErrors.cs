namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Computes the fitting errors ε_i of Eq. (6) after the clock has settled. In the paper, |ε_i| is below 1 ms.</summary>
static class FitErrors
{
    /// <summary>The paper's bound for |ε_i|, ms.</summary>
    public const double BoundMs = 1;

    /// <summary>Minimum share of the exchanges within the bound. The other exchanges are the outliers that RANSAC excludes.</summary>
    public const double MinShare = 0.95;

    public const string Claim = Figure08Texts.FittingError;

    /// <summary>Gets |ε_i| for the exchanges from <see cref="ClockErrors.SettledAfter"/> on, ms.</summary>
    public static double[] Of(IEnumerable<SyncStep> steps) =>
        [.. steps.Where(step => step.Seconds >= ClockErrors.SettledAfter && step.FitErrorMs.HasValue).Select(step => Math.Abs(step.FitErrorMs.Value))];

    /// <summary>Gets |ε_i| with the true offset instead of the fitted one, ms: the errors of the exchanges, which no estimator can remove.</summary>
    /// <param name="first">Φ* of the first exchange. The offsets of the steps are relative to it.</param>
    /// <param name="truth">Gets the true Φ at a headset time.</param>
    public static double[] OfExchanges(IEnumerable<SyncStep> steps, ClockOffset first, Func<HeadsetTime, ClockOffset> truth) =>
        Of(steps.Select(step => step with { FitMs = (truth(step.At) - first).TotalMilliseconds }));

    /// <summary>Gets a sentence with the share of the exchanges that are within the bound relative to the true offset.</summary>
    public static string TextOfExchanges(double[] errors) => errors.Length == 0 ? ""
        : Figure08Texts.ExchangeErrors(Numbers.Percent(ShareBelow(errors)), BoundMs);

    /// <param name="errors">One error or more.</param>
    public static double ShareBelow(double[] errors) => (double)errors.Count(ms => ms < BoundMs) / errors.Length;
}
