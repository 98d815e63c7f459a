using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Runs a clock estimator with recorded exchanges, one step per exchange.</summary>
static class SyncSteps
{
    public static IReadOnlyList<SyncStep> Of(IReadOnlyList<SyncExchange> exchanges, string estimator)
    {
        if (exchanges.Count == 0) return [];
        var clock = new ClockSynchroniser(ClockEstimators.Create(estimator), ClockSettings.Default);
        var (start, first) = (exchanges[0].T4, exchanges[0].Offset);
        var steps = new List<SyncStep>(exchanges.Count);
        foreach (var exchange in exchanges)
        {
            clock.Add(exchange, out _);
            var model = clock.ModelAt(exchange.T4);
            var seconds = (exchange.T4 - start).TotalSeconds;
            double? fit = model.IsKnown ? (model.OffsetAt(exchange.T4) - first).TotalMilliseconds : null;
            double? skew = model.IsKnown ? model.Skew : null;
            steps.Add(new SyncStep(
                seconds, (exchange.Offset - first).TotalMilliseconds, fit, 1e6 * skew, fit - 1e3 * skew * seconds,
                (exchange.T4 - exchange.T1).TotalMilliseconds));
        }
        return steps;
    }
}
