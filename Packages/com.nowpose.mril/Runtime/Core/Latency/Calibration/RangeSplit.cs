using System;

namespace Nowpose.Latency.Calibration
{
    /// <summary>Where a row of good and bad, sorted by render time, turns from mostly good to mostly bad.</summary>
    /// <remarks>
    /// Below the split a pair is bad by chance p, beyond it by chance q; of all splits the one is taken under which the row
    /// is likeliest, with p up to a fifth (misread pictures, frames behind a slow one) and q from 70 % up.
    /// </remarks>
    readonly struct RangeSplit
    {
        const double LeastBelow = 0.005, GreatestBelow = 0.2, LeastBeyond = 0.7, GreatestBeyond = 0.999;

        /// <summary>So many pairs beyond, at least, make a limit: a few may be misread.</summary>
        const int LeastBeyondCount = 12;

        /// <summary>And so large a share of all: at any load one frame in a hundred is slow by itself.</summary>
        const double LeastBeyondShare = 0.04;

        /// <summary>So much likelier, as a logarithm, than that the row never turns.</summary>
        const double LeastEvidence = 12;

        RangeSplit(int count, bool isReached)
        {
            Count = count;
            IsReached = isReached;
        }

        /// <summary>Pairs below the split, one or more.</summary>
        public int Count { get; }

        /// <summary>Whether enough beyond it is bad to call it a limit.</summary>
        public bool IsReached { get; }

        /// <param name="good">Sorted by render time.</param>
        /// <param name="isLast">Whether a pair is the last with its render time: a source that counts in steps gives many the same one.</param>
        public static RangeSplit Find(bool[] good, bool[] isLast)
        {
            var all = 0;
            foreach (var isGood in good) all += isGood ? 0 : 1;
            var never = LogLikelihood(all, good.Length, LeastBelow, GreatestBelow);
            var best = double.NegativeInfinity;
            int count = good.Length, below = 0;
            for (var i = 1; i <= good.Length; i++)
            {
                if (!good[i - 1]) below++;
                if (!isLast[i - 1]) continue;
                var likelihood = LogLikelihood(below, i, LeastBelow, GreatestBelow)
                    + LogLikelihood(all - below, good.Length - i, LeastBeyond, GreatestBeyond);
                if (likelihood <= best) continue;
                best = likelihood;
                count = i;
            }
            var beyond = good.Length - count;
            return new RangeSplit(count, beyond >= LeastBeyondCount && beyond >= LeastBeyondShare * good.Length && best - never >= LeastEvidence);
        }

        static double LogLikelihood(int bad, int count, double least, double greatest)
        {
            if (count == 0) return 0;
            var chance = Math.Min(Math.Max((double)bad / count, least), greatest);
            return bad * Math.Log(chance) + (count - bad) * Math.Log(1 - chance);
        }
    }
}
