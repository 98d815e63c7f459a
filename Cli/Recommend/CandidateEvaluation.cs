using System.Collections.Concurrent;

namespace Nowpose.Cli.Recommend;

/// <summary>Evaluates all candidates on each recording. Runs in parallel on all processors.</summary>
sealed class CandidateEvaluation(IReadOnlyList<ISubject> subjects)
{
    readonly ConcurrentDictionary<(ISubject Subject, string Predictor), Trial> _results = new();

    public int Runs => subjects.Count * Candidates.Names.Count;

    /// <summary>Number of finished runs.</summary>
    public int Done => _results.Count;

    /// <param name="report">Receives the number of finished runs. Called from several threads, but never concurrently.</param>
    /// <param name="cancellation">Stops the evaluation. Finished runs are kept.</param>
    /// <exception cref="InputException">The recording cannot be scored.</exception>
    public void Run(Action<int> report, CancellationToken cancellation)
    {
        var gate = new object();
        var runs = from predictor in Candidates.Names from subject in subjects select (subject, predictor);
        try
        {
            // Preserves the order of the runs, because the references that all candidates are compared with come first.
            Parallel.ForEach(
                Partitioner.Create(runs, EnumerablePartitionerOptions.NoBuffering),
                new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation },
                run =>
                {
                    _results[run] = run.subject.Try(run.predictor, cancellation: cancellation);
                    lock (gate) report(_results.Count);
                });
        }
        catch (OperationCanceledException)
        {
            // Cancelled: the finished results are kept.
        }
        catch (AggregateException faults)
        {
            throw faults.InnerExceptions.OfType<InputException>().FirstOrDefault() ?? faults.InnerExceptions[0];
        }
    }

    /// <summary>
    /// Gets a recommendation for each recording on which the default predictor and at least one other candidate were evaluated.
    /// </summary>
    public IReadOnlyList<Recommendation> Recommendations() =>
        [.. subjects.Select(subject => (subject, trials: TrialsOn(subject))).Where(s => s.trials.Count > 1).Select(s => new Recommendation(s.subject, s.trials))];

    // None without the default predictor, which is the first candidate.
    List<Trial> TrialsOn(ISubject subject)
    {
        var trials = new List<Trial>();
        foreach (var predictor in Candidates.Names)
            if (_results.TryGetValue((subject, predictor), out var trial)) trials.Add(trial);
            else if (trials.Count == 0) break;
        return trials;
    }
}
