using Nowpose.Session.Hindcast;

namespace Nowpose.Cli.Demo;

/// <summary>Compares the displayed values with the true ones frame by frame, and computes the results of the run.</summary>
sealed class DemoScore
{
    /// <summary>Time before which no frame is scored, even if the clock has converged: buffers fill and code is compiled.</summary>
    public static readonly TimeSpan WarmUp = TimeSpan.FromSeconds(3);

    readonly DemoRun _run;
    readonly TimeSpan? _converged;
    readonly ToolKinematics _kinematics;

    public DemoScore(DemoRun run)
    {
        _run = run;
        _kinematics = new ToolKinematics(run.Settings.Robot);
        _converged = FirstSynchronised();
        Errors = ScoredFrames().Select(ErrorOf).ToList();
    }

    /// <summary>Errors of the scored frames, in order.</summary>
    public IReadOnlyList<DemoError> Errors { get; }

    /// <summary>P95 of the error without compensation, mm; null if no frame was scored.</summary>
    public double? HoldP95Mm => Quantile.OfOrNull(Errors.Select(e => e.HoldMm), 0.95);

    /// <summary>Comparison of the cell's objects with their true poses.</summary>
    public BodyScore Bodies => new(_run, ScoredFrames());

    public DemoRange Range => new(_run, Errors);

    public DemoResult Result()
    {
        var statistics = _run.Statistics;
        return new DemoResult(
            Seconds(), _run.Frames.Rows.Count, statistics.Samples, statistics.Dropped,
            _run.Settings.Network.Name, Latencies(), Clock(), Tool(), Frame(), Hindcast(), Range.Result(), LightErrors(), Bodies.Result())
        { FramesScored = Errors.Count, FramesLate = _run.Frames.Late().Count, Conditions = DemoConditions.Of(_run.Settings) };
    }

    // A display without vertices to render has 60 frames per second. Rendering can slow it down.
    double Seconds() => !_run.Settings.IsRendered
        ? Round(_run.Frames.Rows.Count / (double)DemoDisplay.FramesPerSecond)
        : Round(_run.Frames.Rows.Select(row => row.Elapsed.TotalSeconds + 1.0 / DemoDisplay.FramesPerSecond).LastOrDefault());

    TimeSpan? FirstSynchronised()
    {
        foreach (var row in _run.Frames.Rows)
            if (row.Clock.State == ClockState.Synchronised) return row.Elapsed;
        return null;
    }

    IEnumerable<int> ScoredFrames() => Enumerable.Range(0, _run.Frames.Rows.Count)
        .Where(i => IsScored(_run.Frames.Rows[i]));

    // A frame without an estimated display time is not scored, because the runtime could not predict for it.
    bool IsScored(in DemoFrames.Row row) => row.Elapsed >= WarmUp && row.Elapsed >= _converged && row.AssumedLight.HasValue;

    DemoError ErrorOf(int frame)
    {
        var row = _run.Frames.Rows[frame];
        var truth = _kinematics.TrueAt(_run.Truth, row.TrueLight);
        return new DemoError(
            frame, row.HeldTool.DistanceMm(truth), row.Tool.DistanceMm(truth),
            (row.AssumedLight.Value - row.TrueLight).TotalMilliseconds, InTimeMm(row), _run.Truth.CycleAt(row.TrueLight));
    }

    double InTimeMm(in DemoFrames.Row row)
    {
        var inTime = _run.Truth.ControlAt(row.Start + TimeSpan.FromMilliseconds(_run.Settings.VisualisationMs));
        return row.Tool.DistanceMm(_kinematics.TrueAt(_run.Truth, inTime));
    }

    DemoResult.Latencies Latencies()
    {
        var app = _run.ApplicationLatencies.Select(l => l.TotalMilliseconds).ToList();
        return new DemoResult.Latencies(
            Quantile.OfOrNull(app, 0.5), Quantile.OfOrNull(app, 0.95), _run.Settings.VisualisationMs,
            Quantile.OfOrNull(Errors.Select(e => Math.Abs(e.LightMs)), 0.95));
    }

    DemoResult.LightErrors LightErrors()
    {
        var errors = Errors.Select(e => Math.Abs(e.LightMs)).ToList();
        return new DemoResult.LightErrors(Quantile.OfOrNull(errors, 0.5), Quantile.OfOrNull(errors, 0.95), Quantile.OfOrNull(errors, 1));
    }

    DemoResult.ClockErrors Clock()
    {
        var rows = _run.Frames.Rows.Where(row => row.Elapsed >= _converged).ToList();
        var errors = rows.Select(row => Math.Abs(row.OffsetErrorUs)).ToList();
        return new DemoResult.ClockErrors(
            Quantile.OfOrNull(errors, 0.5), Quantile.OfOrNull(errors, 0.95), Quantile.OfOrNull(errors, 1), SkewErrorPpm(rows), _converged?.TotalSeconds,
            Quantile.OfOrNull(rows.Select(row => row.Clock.EstimatedError.TotalMicroseconds), 0.5),
            rows.Count == 0 ? null : (double)rows.Count(row => Math.Abs(row.OffsetErrorUs) <= row.Clock.EstimatedError.TotalMicroseconds) / rows.Count);
    }

    // Uses the last value, which is the most accurate one, because the skew is an average over the whole history.
    double? SkewErrorPpm(List<DemoFrames.Row> rows)
    {
        if (rows.Count < 2) return null;
        var (first, last) = (rows[0].Start, rows[^1].Start);
        var trueSkew = (_run.Truth.OffsetAt(last) - _run.Truth.OffsetAt(first)) / (last - first);
        return (rows[^1].Clock.Skew - trueSkew) * 1e6;
    }

    DemoResult.ToolErrors Tool()
    {
        var (all, first, repeated) = (Compare(_ => true), Compare(cycle => cycle == 0), Compare(cycle => cycle >= 2));
        return new DemoResult.ToolErrors(
            all?.RmsHold, Quantile.OfOrNull(Errors.Select(e => e.HoldMm), 1), all?.Rms, all?.P95, all?.Max, all?.Reduction,
            first?.Reduction, repeated?.Reduction);
    }

    ErrorComparison? Compare(Func<int, bool> ofCycle) => ErrorComparison.Of(Errors.Where(e => ofCycle(e.Cycle)).Select(e => (e.HoldMm, e.Mm)));

    DemoResult.FrameCost Frame()
    {
        if (_run.Settings.IsVirtual) return new DemoResult.FrameCost(null, null, null);
        var warm = _run.Frames.Rows.Where(row => row.Elapsed >= WarmUp).ToList();
        return new DemoResult.FrameCost(
            Quantile.OfOrNull(warm.Select(row => row.CpuUs), 0.5), Quantile.OfOrNull(warm.Select(row => row.CpuUs), 0.99),
            warm.Count == 0 ? null : warm.Average(row => (double)row.AllocatedBytes));
    }

    DemoResult.Hindcasts Hindcast()
    {
        var error = _run.Statistics.ToolErrorOfRun;
        return new DemoResult.Hindcasts(
            error?.Reduction, error?.ReductionUncertainty, error?.Rms, error?.HoldRms,
            WithheldErrors.WordsOf(_run.Statistics.ErrorOfRunWithheld));
    }

    static double Round(double seconds) => Math.Round(seconds, 3);
}

/// <summary>The errors of one scored frame.</summary>
/// <param name="Frame">Index among all frames.</param>
/// <param name="HoldMm">Distance between the uncompensated tool and the true one, mm.</param>
/// <param name="Mm">Distance between the displayed tool and the true one, mm.</param>
/// <param name="LightMs">Assumed minus true display time, ms.</param>
/// <param name="InTimeMm">Value that <paramref name="Mm"/> would have if the frame had been displayed without delay, mm.</param>
/// <param name="Cycle">Index of the motion cycle at the display time, from 0.</param>
readonly record struct DemoError(int Frame, double HoldMm, double Mm, double LightMs, double InTimeMm, int Cycle);
