namespace Nowpose.Cli.Recommend;

/// <summary>What a recording is like, as far as it bears on what can be recommended from it.</summary>
sealed class RecordingTraits
{
    /// <summary>Shorter, and the halves say more about chance than about the machine, s.</summary>
    const double LeastDuration = 10;

    /// <summary>Of rad or m: less than any robot moves on purpose.</summary>
    const double Standstill = 1e-4;

    /// <summary>A joint that rests repeats its value for longer.</summary>
    const int LongestRepeat = 4;

    const double NoticeableSpread = 0.2;
    const double NoticeableRepeats = 0.01;

    public RecordingTraits(IReadOnlyList<JointSeries> joints)
    {
        var moving = joints.Where(joint => joint.Positions.Count > 1).ToList();
        Duration = moving.Select(joint => joint.Times[^1] - joint.Times[0]).DefaultIfEmpty().Max();
        var intervals = moving.SelectMany(joint => joint.Times.Zip(joint.Times.Skip(1), (a, b) => b - a)).ToList();
        if (intervals.Count > 0)
            (Interval, IntervalP5, IntervalP95) = (Quantile.Of(intervals, 0.5), Quantile.Of(intervals, 0.05), Quantile.Of(intervals, 0.95));
        GreatestRange = moving.Select(joint => joint.Positions.Max() - joint.Positions.Min()).DefaultIfEmpty().Max();
        Repeats = RepeatsOf(moving);
        RoundingSteps = [.. moving.Select(joint => (joint.Name, Step: RoundingStepOf(joint.Positions))).Where(joint => joint.Step.HasValue)
            .Select(joint => (joint.Name, joint.Step.Value))];
    }

    /// <summary>s.</summary>
    public double Duration { get; }

    /// <summary>From one sample to the next, median, s.</summary>
    public double Interval { get; }

    /// <summary>s.</summary>
    public double IntervalP5 { get; }

    /// <summary>s.</summary>
    public double IntervalP95 { get; }

    /// <summary>The farthest way of any joint, rad or m.</summary>
    public double GreatestRange { get; }

    /// <summary>Share of the samples of a moving joint that repeat the one before: 0 to 1.</summary>
    public double Repeats { get; }

    /// <summary>Joints whose values lie on a grid, and its step, rad or m.</summary>
    public IReadOnlyList<(string Name, double Step)> RoundingSteps { get; }

    /// <summary>What whoever follows the recommendation should know.</summary>
    public IEnumerable<string> Warnings()
    {
        if (GreatestRange < Standstill)
            yield return Text($"nothing moves by more than {GreatestRange:G2} rad or m: from a standstill nothing can be recommended");
        if (Duration < LeastDuration)
            yield return Text($"{Duration:0.0} s are short: chance may decide; record {LeastDuration} s or more");
        if (IntervalP95 - IntervalP5 > NoticeableSpread * Interval)
            yield return Text($"the samples' stamps lie {1e3 * IntervalP5:0.0} to {1e3 * IntervalP95:0.0} ms apart (P5 to P95): ")
                + "a stamp given late costs accuracy";
        if (Repeats > NoticeableRepeats)
            yield return Text($"{100 * Repeats:0.0} % of a moving joint's samples repeat the one before: ")
                + "the machine, or its rounding, is coarser than the recording";
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
                if (run <= LongestRepeat) repeats += run - 1;
                run = 1;
            }
        }
        return changes == 0 ? 0 : repeats / (double)(changes + repeats);
    }

    // The least step that occurs, when nearly all others are multiples of it.
    static double? RoundingStepOf(IReadOnlyList<double> positions)
    {
        const double noise = 1e-9;
        var steps = positions.Zip(positions.Skip(1), (a, b) => Math.Abs(b - a)).Where(step => step > noise).ToList();
        if (steps.Count < 20) return null;
        var least = steps.Min();
        var multiples = steps.Count(step => Math.Abs(step / least - Math.Round(step / least)) < 0.01);
        // Of a smooth motion, steps of every size occur: the least is then a thousandth of the others.
        return multiples > 0.99 * steps.Count && Quantile.Of(steps, 0.5) < 1000 * least ? Rounded(least) : null;
    }

    static double Rounded(double value)
    {
        var scale = Math.Pow(10, Math.Floor(Math.Log10(value)) - 3);
        return Math.Round(value / scale) * scale;
    }

    static string Text(FormattableString text) => FormattableString.Invariant(text);
}
