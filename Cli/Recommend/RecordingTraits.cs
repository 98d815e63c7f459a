using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Recommend;

/// <summary>Properties of a recording that affect the recommendation.</summary>
sealed class RecordingTraits
{
    /// <summary>Minimum duration, s. In a shorter recording, the halves differ mostly by chance.</summary>
    const double MinDuration = 10;

    /// <summary>Maximum range of a resting joint, rad or m. Any intended motion of a robot is larger.</summary>
    const double Standstill = 1e-4;

    /// <summary>Maximum number of consecutive equal values of a moving joint. More equal values mean that the joint rests.</summary>
    const int MaxRepeats = 4;

    const double NoticeableSpread = 0.2;
    const double NoticeableRepeats = 0.01;

    readonly string _rows;

    /// <param name="samplingMs">Smallest sampling interval T_s of the evaluation, ms; null if the recording contains the samples.</param>
    public RecordingTraits(IReadOnlyList<JointSeries> joints, double? samplingMs = null)
    {
        var moving = joints.Where(joint => joint.Positions.Count > 1).ToList();
        // All joints of a motion have the same times.
        if (samplingMs is double sampled && moving.Count > 0)
            _rows = RowInterval.WarningOf(moving[0].Times, row => moving.Exists(joint => joint.Positions[row] != joint.Positions[row - 1]), sampled);
        Duration = moving.Select(joint => joint.Times[^1] - joint.Times[0]).DefaultIfEmpty().Max();
        var intervals = moving.SelectMany(joint => joint.Times.Zip(joint.Times.Skip(1), (a, b) => b - a)).ToList();
        if (intervals.Count > 0)
            (Interval, IntervalP5, IntervalP95) = (Quantile.Of(intervals, 0.5), Quantile.Of(intervals, 0.05), Quantile.Of(intervals, 0.95));
        MaxRange = moving.Select(joint => joint.Positions.Max() - joint.Positions.Min()).DefaultIfEmpty().Max();
        Repeats = RepeatsOf(moving);
        RoundingSteps = [.. moving.Select(joint => (joint.Name, Step: RoundingStepOf(joint.Positions))).Where(joint => joint.Step.HasValue)
            .Select(joint => (joint.Name, joint.Step.Value))];
    }

    /// <summary>Duration of the recording, s.</summary>
    public double Duration { get; }

    /// <summary>Median interval between samples, s.</summary>
    public double Interval { get; }

    /// <summary>5th percentile of the interval, s.</summary>
    public double IntervalP5 { get; }

    /// <summary>95th percentile of the interval, s.</summary>
    public double IntervalP95 { get; }

    /// <summary>Range of the joint that moves most, rad or m.</summary>
    public double MaxRange { get; }

    /// <summary>Share of the samples of moving joints that have the same value as the previous sample, 0 to 1.</summary>
    public double Repeats { get; }

    /// <summary>Joints whose values are rounded, with the rounding step in rad or m.</summary>
    public IReadOnlyList<(string Name, double Step)> RoundingSteps { get; }

    /// <summary>Gets the warnings about the reliability of the recommendation.</summary>
    public IEnumerable<string> Warnings()
    {
        if (MaxRange < Standstill)
            yield return RecommendMessages.NoMotion(MaxRange);
        // A recording of 9.99 s has 1000 rows at 100 Hz.
        if (Math.Round(Duration, 1) < MinDuration)
            yield return RecommendMessages.Short(Duration, MinDuration);
        if (_rows != null)
            yield return _rows;
        if (IntervalP95 - IntervalP5 > NoticeableSpread * Interval)
            yield return RecommendMessages.LateStamps(1e3 * IntervalP5, 1e3 * IntervalP95);
        if (Repeats > NoticeableRepeats)
            yield return RecommendMessages.Repeats(100 * Repeats);
    }

    static double RepeatsOf(List<JointSeries> joints)
    {
        var (repeats, changes) = (0, 0);
        foreach (var positions in joints.Select(joint => joint.Positions))
        {
            var run = 1;
            for (var i = 1; i < positions.Count; i++)
            {
                if (positions[i] == positions[i - 1])
                {
                    run++;
                    continue;
                }
                changes++;
                if (run <= MaxRepeats) repeats += run - 1;
                run = 1;
            }
        }
        return changes == 0 ? 0 : repeats / (double)(changes + repeats);
    }

    // Returns the smallest step between values if nearly all other steps are multiples of it.
    static double? RoundingStepOf(IReadOnlyList<double> positions)
    {
        const double noise = 1e-9;
        var steps = positions.Zip(positions.Skip(1), (a, b) => Math.Abs(b - a)).Where(step => step > noise).ToList();
        if (steps.Count < 20) return null;
        var min = steps.Min();
        var multiples = steps.Count(step => Math.Abs(step / min - Math.Round(step / min)) < 0.01);
        // A smooth motion without rounding has steps of all sizes, so its smallest step is less than a thousandth of the median step.
        return multiples > 0.99 * steps.Count && Quantile.Of(steps, 0.5) < 1000 * min ? Rounded(min) : null;
    }

    static double Rounded(double value)
    {
        var scale = Math.Pow(10, Math.Floor(Math.Log10(value)) - 3);
        return Math.Round(value / scale) * scale;
    }
}
