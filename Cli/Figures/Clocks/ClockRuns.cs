namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Runs all clock estimators with the same simulated exchanges.</summary>
sealed class ClockRuns
{
    readonly ClockInstant[,][] _runs;
    readonly Lazy<ClockErrors>[] _errors;

    public ClockRuns(FigureSettings settings)
    {
        Seconds = settings.ClockSeconds;
        Logs = [.. Enumerable.Range(0, settings.ClockRuns).Select(i => new SimulatedExchanges(settings.Seed * 1000 + i, Seconds))];
        _runs = new ClockInstant[ClockMethods.All.Count, Logs.Count][];
        // Lazy, so that the errors are computed only once although several figures read them.
        _errors = [.. Enumerable.Range(0, ClockMethods.All.Count).Select(
            m => new Lazy<ClockErrors>(() => ClockErrors.Of([.. Logs.Select((log, l) => (_runs[m, l], log))])))];
        Work = [.. from m in Enumerable.Range(0, ClockMethods.All.Count) from l in Enumerable.Range(0, Logs.Count)
            select (Action)(() => _runs[m, l] = ClockRun.Of(ClockMethods.All[m], Logs[l], Seconds))];
    }

    /// <summary>Gets |ε_i| of Eq. (6) for the paper's estimator over all logs, ms.</summary>
    public double[] FitErrorsMs => [.. Logs.SelectMany(log => FitErrors.Of(StepsOf(log)))];

    /// <summary>Gets |ε_i| with the true offset instead of the fitted one, ms: the errors of the exchanges themselves.</summary>
    public double[] ExchangeErrorsMs => [.. Logs.SelectMany(log => FitErrors.OfExchanges(StepsOf(log), log.All[0].Offset, log.TrueOffset))];

    static IReadOnlyList<SyncStep> StepsOf(SimulatedExchanges log) => SyncSteps.Of(log.All, ClockMethods.All[0]);

    /// <summary>Length of each log, s.</summary>
    public double Seconds { get; }

    public IReadOnlyList<SimulatedExchanges> Logs { get; }

    public IReadOnlyList<Action> Work { get; }

    /// <summary>Gets a method's estimates over the first log. The index refers to <see cref="ClockMethods.All"/>.</summary>
    public IReadOnlyList<ClockInstant> First(int method) => _runs[method, 0];

    /// <summary>Gets a method's errors over all logs. The index refers to <see cref="ClockMethods.All"/>.</summary>
    public ClockErrors Errors(int method) => _errors[method].Value;
}
