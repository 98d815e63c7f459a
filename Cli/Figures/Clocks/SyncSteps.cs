using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Feeds recorded exchanges to a clock estimator.</summary>
static class SyncSteps
{
    /// <returns>One step for each exchange, without those that the estimator dropped as invalid.</returns>
    public static IReadOnlyList<SyncStep> Of(IEnumerable<SyncExchange> exchanges, string estimator)
    {
        var clock = new ClockSynchroniser(ClockEstimators.Create(estimator), ClockSettings.Default);
        var steps = new List<SyncStep>();
        SyncExchange? first = null;
        foreach (var exchange in exchanges)
        {
            if (clock.Add(exchange, out _) == SyncVerdict.Dropped) continue;
            first ??= exchange;
            steps.Add(StepOf(exchange, first.Value, clock.ModelAt(exchange.T4)));
        }
        return steps;
    }

    static SyncStep StepOf(in SyncExchange exchange, in SyncExchange first, in ClockModel model)
    {
        var seconds = (exchange.T4 - first.T4).TotalSeconds;
        double? fit = model.IsKnown ? (model.OffsetAt(exchange.T4) - first.Offset).TotalMilliseconds : null;
        double? skew = model.IsKnown ? model.Skew : null;
        return new SyncStep(
            seconds, (exchange.Offset - first.Offset).TotalMilliseconds, fit, 1e6 * skew, fit - 1e3 * skew * seconds,
            (exchange.T4 - exchange.T1).TotalMilliseconds)
        { Exchange = exchange };
    }
}
