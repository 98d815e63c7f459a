namespace Nowpose.Cli.Figures.Clocks;

/// <summary>Runs every clock estimator on the same simulated logs.</summary>
sealed class ClockRuns
{
    readonly ClockInstant[,][] _runs;
    readonly Lazy<ClockErrors>[] _errors;

    public ClockRuns(FigureSettings settings)
    {
        Seconds = settings.ClockSeconds;
        Logs = [.. Enumerable.Range(0, settings.ClockRuns).Select(i => new SimulatedExchanges(settings.Seed * 1000 + i, Seconds))];
        _runs = new ClockInstant[ClockMethod.All.Count, Logs.Count][];
        // Computed once, because figures read it row by row.
        _errors = [.. Enumerable.Range(0, ClockMethod.All.Count).Select(
            m => new Lazy<ClockErrors>(() => ClockErrors.Of([.. Logs.Select((log, l) => (_runs[m, l], log))])))];
        Work = [.. from m in Enumerable.Range(0, ClockMethod.All.Count) from l in Enumerable.Range(0, Logs.Count)
            select (Action)(() => _runs[m, l] = ClockRun.Of(ClockMethod.All[m], Logs[l], Seconds))];
    }

    /// <summary>Gets |ε_i| of Eq. (6) of the paper's estimator over all logs, ms.</summary>
    public double[] FitErrorsMs => [.. Logs.SelectMany(log => FitErrors.Of(StepsOf(log)))];

    /// <summary>Gets the same with the true offset instead of the fit: the errors of the exchanges themselves.</summary>
    public double[] ExchangeErrorsMs => [.. Logs.SelectMany(log => FitErrors.OfExchanges(StepsOf(log), log.All[0].Offset, log.TrueOffset))];

    static IReadOnlyList<SyncStep> StepsOf(SimulatedExchanges log) => SyncSteps.Of(log.All, ClockMethod.All[0].Name);

    /// <summary>Length of each log, s.</summary>
    public double Seconds { get; }

    public IReadOnlyList<SimulatedExchanges> Logs { get; }

    public IReadOnlyList<Action> Work { get; }

    /// <summary>Gets the estimates of a method, by its index in <see cref="ClockMethod.All"/>, over the first log.</summary>
    public IReadOnlyList<ClockInstant> First(int method) => _runs[method, 0];

    /// <summary>Gets the errors of a method over all logs.</summary>
    public ClockErrors Errors(int method) => _errors[method].Value;
}
