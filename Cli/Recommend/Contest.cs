using System.Collections.Concurrent;
using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>Tries all candidates on both halves of each subject, as many in parallel as there are cores.</summary>
sealed class Contest(IReadOnlyList<ISubject> subjects)
{
    readonly ConcurrentDictionary<(ISubject Subject, string Predictor, Half Half), ReplayResult> _results = new();

    public int Runs => subjects.Count * Candidates.Names.Count * 2;

    /// <param name="report">Receives the number of finished runs; called from several threads, one at a time.</param>
    /// <param name="cancellation">Stops the contest. Finished runs are kept.</param>
    /// <exception cref="InputException">The recording cannot be scored.</exception>
    public void Run(Action<int> report, CancellationToken cancellation)
    {
        var gate = new object();
        var runs = from predictor in Candidates.Names from subject in subjects from half in Enum.GetValues<Half>() select (subject, predictor, half);
        try
        {
            // Kept in order: the candidates that all others are compared with come first.
            Parallel.ForEach(
                Partitioner.Create(runs, EnumerablePartitionerOptions.NoBuffering),
                new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation },
                run =>
                {
                    var result = run.subject.Try(run.predictor, run.half, cancellation: cancellation);
                    // An interrupted run has no valid result.
                    if (cancellation.IsCancellationRequested) return;
                    _results[run] = result;
                    lock (gate) report(_results.Count);
                });
        }
        catch (OperationCanceledException)
        {
            // Interrupted: the finished results are kept.
        }
        catch (AggregateException faults)
        {
            throw faults.InnerExceptions.OfType<InputException>().FirstOrDefault() ?? faults.InnerExceptions[0];
        }
    }

    /// <summary>Gets one verdict for each subject on which the default was tried.</summary>
    public IReadOnlyList<Verdict> Verdicts() =>
        [.. subjects.Select(subject => (subject, trials: TrialsOn(subject))).Where(s => s.trials.Count > 1).Select(s => new Verdict(s.subject, s.trials))];

    List<Trial> TrialsOn(ISubject subject)
    {
        var trials = new List<Trial>();
        foreach (var predictor in Candidates.Names)
            if (_results.TryGetValue((subject, predictor, Half.First), out var first)
                && _results.TryGetValue((subject, predictor, Half.Second), out var second))
                trials.Add(new Trial(predictor, first, second));
            else if (trials.Count == 0)
                break;
        return trials;
    }
}
