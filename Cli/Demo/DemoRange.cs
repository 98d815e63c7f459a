using Nowpose.Latency;

namespace Nowpose.Cli.Demo;

/// <summary>How a run with a load stood to the constant-latency range, as the runtime saw it and as it was.</summary>
sealed class DemoRange(DemoRun run, IReadOnlyList<DemoError> errors)
{
    /// <summary>result.json's object; null without a load.</summary>
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

    /// <summary>Median of the true L_visu of scored frames inside or outside, ms; null where there are none.</summary>
    public double? VisualisationMs(bool isOutside)
    {
        var lengths = Of(isOutside).Select(e => run.Frames.Rows[e.Frame].Rendered.Visualisation.TotalMilliseconds).ToList();
        return lengths.Count == 0 ? null : Quantile.Of(lengths, 0.5);
    }

    /// <summary>RMS of the compensated tool's error over scored frames outside, mm; null where there are none.</summary>
    public double? RmsOutsideMm => RmsMm(e => e.Mm);

    /// <summary>The same of the same frames, had their light not been late: what the load alone adds is the difference.</summary>
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
