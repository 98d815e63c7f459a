namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Split of a sequence of good and bad pairs, sorted by render time, where it changes from mostly good to mostly bad.</summary>
/// <remarks>
/// A pair is bad with probability p below the split and q beyond it. The split is the one with the maximum likelihood, with p up
/// to 0.2 (misread pictures, frames behind a slow one) and q of 0.7 or more.
/// </remarks>
readonly struct RangeSplit
{
    const double MinShareBelow = 0.005, MaxShareBelow = 0.2, MinShareBeyond = 0.7, MaxShareBeyond = 0.999;

    /// <summary>Minimum number of pairs beyond a limit; a few of them may be misread.</summary>
    const int MinBeyondCount = 12;

    /// <summary>Minimum share of all pairs beyond a limit: at any load, about one frame in a hundred is slow.</summary>
    const double MinBeyondFraction = 0.04;

    /// <summary>Minimum log-likelihood ratio of the split to a sequence without a split.</summary>
    const double MinEvidence = 12;

    RangeSplit(int count, bool isReached)
    {
        Count = count;
        IsReached = isReached;
    }

    /// <summary>Number of pairs below the split, one or more.</summary>
    public int Count { get; }

    /// <summary>Whether the evidence beyond the split suffices for a limit.</summary>
    public bool IsReached { get; }

    /// <param name="good">Whether each pair is good, sorted by render time.</param>
    /// <param name="isLast">Whether a pair is the last with its render time: a source with a coarse resolution repeats values.</param>
    public static RangeSplit Find(bool[] good, bool[] isLast)
    {
        var all = 0;
        foreach (var isGood in good) all += isGood ? 0 : 1;
        var never = LogLikelihood(all, good.Length, MinShareBelow, MaxShareBelow);
        var best = double.NegativeInfinity;
        int count = good.Length, below = 0;
        for (var i = 1; i <= good.Length; i++)
        {
            if (!good[i - 1]) below++;
            if (!isLast[i - 1]) continue;
            var likelihood = LogLikelihood(below, i, MinShareBelow, MaxShareBelow)
                + LogLikelihood(all - below, good.Length - i, MinShareBeyond, MaxShareBeyond);
            if (likelihood <= best) continue;
            best = likelihood;
            count = i;
        }
        var beyond = good.Length - count;
        return new RangeSplit(count, beyond >= MinBeyondCount && beyond >= MinBeyondFraction * good.Length && best - never >= MinEvidence);
    }

    static double LogLikelihood(int bad, int count, double min, double max)
    {
        if (count == 0) return 0;
        var chance = Math.Min(Math.Max((double)bad / count, min), max);
        return bad * Math.Log(chance) + (count - bad) * Math.Log(1 - chance);
    }
}
