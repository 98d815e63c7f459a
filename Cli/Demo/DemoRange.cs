using Nowpose.Latency;

namespace Nowpose.Cli.Demo;

/// <summary>Evaluates the runtime's range state in a run under load.</summary>
sealed class DemoRange(DemoRun run, IReadOnlyList<DemoError> errors)
{
    /// <summary>Gets the values for result.json; null without a load.</summary>
    public DemoResult.Ranges Result()
    {
        if (run.Settings.Load == null) return null;
        var rows = run.Frames.Rows;
        var left = rows.FindIndex(row => row.Range == RangeState.Outside);
        var found = left < 0 ? -1 : rows.FindLastIndex(row => row.Range == RangeState.Outside) + 1;
        return new DemoResult.Ranges(
            run.Limit?.TotalMilliseconds, Elapsed(left), found < rows.Count ? Elapsed(found) : null,
            rows.Count(row => row.Range == RangeState.Outside), run.Alarms);
    }

    /// <summary>Gets the median of the true L_visu of the scored frames inside or outside the range, ms; null if there are none.</summary>
    public double? VisualisationMs(bool isOutside)
    {
        var lengths = Of(isOutside).Select(e => run.Frames.Rows[e.Frame].Rendered.Visualisation.TotalMilliseconds).ToList();
        return lengths.Count == 0 ? null : Quantile.Of(lengths, 0.5);
    }

    /// <summary>RMS error of the compensated tool over the scored frames outside the range, mm; null if there are none.</summary>
    public double? RmsOutsideMm => RmsMm(e => e.Mm);

    /// <summary>RMS error that the same frames would have if they had been displayed without delay, mm; null if there are none.</summary>
    public double? RmsInTimeMm => RmsMm(e => e.InTimeMm);

    double? RmsMm(Func<DemoError, double> error)
    {
        var squares = Of(isOutside: true).Select(e => error(e) * error(e)).ToList();
        return squares.Count == 0 ? null : Math.Sqrt(squares.Average());
    }

    IEnumerable<DemoError> Of(bool isOutside) =>
        errors.Where(e => run.Frames.Rows[e.Frame].Range == RangeState.Outside == isOutside);

    double? Elapsed(int frame) => frame < 0 ? null : Math.Round(run.Frames.Rows[frame].Elapsed.TotalSeconds, 3);
}
