namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Splits a sequence of pairs, sorted by render time, where it changes from mostly good to mostly bad pairs.</summary>
/// <remarks>
/// A pair is bad with probability p below the split and q beyond it. The split maximises the likelihood, where p is at most 0.2 (misread
/// pictures, frames that follow a slow frame) and q is at least 0.7. For the final position, a bad pair counts as three pairs, because a limit
/// that is too high is worse than one that is too low. A source that reports the render time of an earlier frame mixes good and bad
/// pairs of the loads around the limit; the weight moves those loads beyond the limit.
/// </remarks>
/// <param name="Count">Number of pairs below the split, one or more.</param>
/// <param name="MaxCount">Number of pairs below the split if bad pairs have the same weight as good ones. At least <paramref name="Count"/>.</param>
/// <param name="IsReached">Whether there are enough pairs beyond the split, and enough of them are bad, to establish a limit.</param>
readonly record struct RangeSplit(int Count, int MaxCount, bool IsReached)
{
    const double MinShareBelow = 0.005, MaxShareBelow = 0.2, MinShareBeyond = 0.7, MaxShareBeyond = 0.999;

    /// <summary>Weight of a bad pair: it counts as this number of pairs.</summary>
    const double WeightOfBad = 3;

    /// <summary>Minimum number of pairs beyond a limit. A few of them can be misread.</summary>
    const int MinBeyondCount = 12;

    /// <summary>Minimum share of the pairs beyond a limit. At any load, about 1 % of the frames are slow.</summary>
    const double MinBeyondFraction = 0.04;

    /// <summary>Minimum log-likelihood ratio between the split and no split.</summary>
    const double MinEvidence = 12;

    /// <param name="good">Whether each pair is good, sorted by render time.</param>
    /// <param name="isLast">Whether a pair is the last one with its render time. A source with a coarse resolution repeats values.</param>
    public static RangeSplit Find(bool[] good, bool[] isLast)
    {
        var (max, evidence) = Best(good, isLast, 1);
        var beyond = good.Length - max;
        var isReached = beyond >= MinBeyondCount && beyond >= MinBeyondFraction * good.Length && evidence >= MinEvidence;
        return new RangeSplit(isReached ? Math.Min(max, Best(good, isLast, WeightOfBad).Count) : max, max, isReached);
    }

    /// <returns>The split with the maximum likelihood, and its log-likelihood ratio against no split.</returns>
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
