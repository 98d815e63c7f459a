namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Split of a sequence of good and bad pairs, sorted by render time, where it changes from mostly good to mostly bad.</summary>
/// <remarks>
/// A pair is bad with probability p below the split and q beyond it. The split is the one with the maximum likelihood, with p up
/// to 0.2 (misread pictures, frames behind a slow one) and q of 0.7 or more. A bad pair counts as three, because a limit that is too
/// high is worse than one that is too low: where a source reports the render time of an earlier frame, good and bad pairs of the loads
/// around the limit are mixed, and those loads belong beyond it.
/// </remarks>
readonly struct RangeSplit
{
    const double MinShareBelow = 0.005, MaxShareBelow = 0.2, MinShareBeyond = 0.7, MaxShareBeyond = 0.999;

    /// <summary>Number of good pairs beyond the split that are as bad as one bad pair below it.</summary>
    const double WeightOfBad = 3;

    /// <summary>Minimum number of pairs beyond a limit; a few of them may be misread.</summary>
    const int MinBeyondCount = 12;

    /// <summary>Minimum share of all pairs beyond a limit: at any load, about one frame in a hundred is slow.</summary>
    const double MinBeyondFraction = 0.04;

    /// <summary>Minimum log-likelihood ratio of the split to a sequence without a split.</summary>
    const double MinEvidence = 12;

    RangeSplit(int count, int maxCount, bool isReached)
    {
        Count = count;
        MaxCount = maxCount;
        IsReached = isReached;
    }

    /// <summary>Number of pairs below the split, one or more.</summary>
    public int Count { get; }

    /// <summary>Number of pairs below the split if a bad pair counts as one: <see cref="Count"/> or more.</summary>
    public int MaxCount { get; }

    /// <summary>Whether the evidence beyond the split suffices for a limit.</summary>
    public bool IsReached { get; }

    /// <param name="good">Whether each pair is good, sorted by render time.</param>
    /// <param name="isLast">Whether a pair is the last with its render time: a source with a coarse resolution repeats values.</param>
    public static RangeSplit Find(bool[] good, bool[] isLast)
    {
        var (max, evidence) = Best(good, isLast, 1);
        var beyond = good.Length - max;
        var isReached = beyond >= MinBeyondCount && beyond >= MinBeyondFraction * good.Length && evidence >= MinEvidence;
        return new RangeSplit(isReached ? Math.Min(max, Best(good, isLast, WeightOfBad).Count) : max, max, isReached);
    }

    /// <returns>The split with the maximum likelihood, and the log-likelihood ratio of it to a sequence without a split.</returns>
    static (int Count, double Evidence) Best(bool[] good, bool[] isLast, double weight)
    {
        var all = good.Count(isGood => !isGood);
        double LikelihoodOf(int bad, int pairs) => LogLikelihood(weight * bad, pairs - bad, MinShareBelow, MaxShareBelow)
            + LogLikelihood(weight * (all - bad), good.Length - pairs - (all - bad), MinShareBeyond, MaxShareBeyond);
        var best = double.NegativeInfinity;
        int count = good.Length, below = 0;
        for (var i = 1; i <= good.Length; i++)
        {
            if (!good[i - 1]) below++;
            if (!isLast[i - 1]) continue;
            var likelihood = LikelihoodOf(below, i);
            if (likelihood > best) (best, count) = (likelihood, i);
        }
        return (count, best - LikelihoodOf(all, good.Length));
    }

    static double LogLikelihood(double bad, double good, double min, double max)
    {
        if (bad + good == 0) return 0;
        var chance = Math.Clamp(bad / (bad + good), min, max);
        return bad * Math.Log(chance) + good * Math.Log(1 - chance);
    }
}
