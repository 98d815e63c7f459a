using System;

namespace Nowpose.Sync
{
    /// <summary>Constants of the paper's estimator; the defaults are the values of Fig. 8.</summary>
    public sealed class RansacSettings
    {
        public static readonly RansacSettings Paper = new RansacSettings();

        /// <param name="history">Number of exchanges kept.</param>
        /// <param name="hypotheses">Number of lines tried at each exchange.</param>
        /// <param name="inlierBoundMs">Maximum distance of an inlier from the line, ms, 0.01 to 1000.</param>
        /// <param name="movingAverage">Number of fitted lines in the average.</param>
        /// <param name="seed">Seed of the random choice of hypotheses, so that the same log gives the same result.</param>
        public RansacSettings(int history = 100, int hypotheses = 20, double inlierBoundMs = 1, int movingAverage = 20, int seed = 1)
        {
            History = SettingRange.RequireCount(history, 3, 10_000, nameof(history));
            Hypotheses = SettingRange.RequireCount(hypotheses, 1, 10_000, nameof(hypotheses));
            MovingAverage = SettingRange.RequireCount(movingAverage, 1, 10_000, nameof(movingAverage));
            InlierBound = SettingRange.RequireMs(inlierBoundMs, 0.01, 1000, "inlier bound");
            Seed = seed;
        }

        public int History { get; }
        public int Hypotheses { get; }
        public TimeSpan InlierBound { get; }
        public int MovingAverage { get; }
        public int Seed { get; }
    }
}
