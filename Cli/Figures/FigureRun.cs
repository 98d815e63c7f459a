using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures;

/// <summary>Runs the work items of all studies in parallel on all processors.</summary>
sealed class FigureRun(IReadOnlyList<IFigureStudy> studies)
{
    /// <summary>Total number of work items.</summary>
    public int Total { get; } = studies.Sum(s => s.Work.Count);

    /// <param name="done">Called with the number of finished items, from any thread.</param>
    /// <returns>The figures in the paper's order. After a cancellation, only those whose work is finished.</returns>
    public IReadOnlyList<Figure> Run(Action<int> done, CancellationToken cancel)
    {
        var left = studies.Select(s => s.Work.Count).ToArray();
        var finished = 0;
        var pieces = studies.SelectMany((study, i) => study.Work.Select(work => (Study: i, Work: work)));
        try
        {
            Parallel.ForEach(pieces, new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = Environment.ProcessorCount }, piece =>
            {
                piece.Work();
                Interlocked.Decrement(ref left[piece.Study]);
                done(Interlocked.Increment(ref finished));
            });
        }
        catch (OperationCanceledException)
        {
            // Cancelled: the figures whose work is finished are returned.
        }
        catch (AggregateException failures)
        {
            throw failures.InnerExceptions[0];
        }
        return [.. studies.Where((_, i) => left[i] == 0).SelectMany(s => s.Figures()).OrderBy(f => Order(f.Number))];
    }

    static int Order(string number) => 100 * int.Parse(number.TrimEnd('a', 'b', 'c', 'd'), System.Globalization.CultureInfo.InvariantCulture)
        + (char.IsLetter(number[^1]) ? number[^1] : 0);
}
