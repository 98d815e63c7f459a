using System;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>Everything a session is told once. Immutable; what adapts while it runs is state of the session.</summary>
    public sealed class SessionSettings
    {
        /// <param name="connection">Where the gateway is.</param>
        /// <param name="visualisation">L_visu of this device at the start.</param>
        /// <param name="prediction">Null for the defaults.</param>
        /// <param name="clock">Null for the defaults.</param>
        /// <param name="ransac">Constants of the paper's clock estimator, where that is chosen; null for its own.</param>
        /// <param name="syncIntervalMs">
        /// From the start of one sync exchange to the next, ms; the server allows 100 requests a second. A quarter of it at
        /// the start and after a step, five times as much on a quiet network, see <see cref="ExchangePace"/>.
        /// </param>
        /// <param name="range">The constant-latency range of this device; null when none was found yet.</param>
        /// <param name="clockEstimator">One of <see cref="ClockEstimators.Names"/>.</param>
        /// <param name="profile">
        /// Takes the place of <paramref name="visualisation"/>, and of <paramref name="range"/> where it knows one; null for none.
        /// </param>
        /// <param name="outsideRange">What is shown while the render time is outside the range.</param>
        /// <param name="rewriteBeforeRender">As <see cref="RewriteBeforeRender"/>; L_visu is calibrated with the same choice.</param>
        public SessionSettings(
            ConnectionSettings connection, VisualisationLatency visualisation, PredictionSettings prediction = null,
            ClockSettings clock = null, RansacSettings ransac = null, double syncIntervalMs = ProtocolLimits.SyncIntervalMs,
            ConstantLatencyRange range = null, bool rewriteBeforeRender = false,
            string clockEstimator = ClockEstimators.Default, LatencyProfile profile = null,
            OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            Profile = profile;
            OutsideRange = outsideRange;
            Range = profile?.WatchedRange ?? range;
            RewriteBeforeRender = rewriteBeforeRender;
            Connection = connection ?? throw new ArgumentNullException(nameof(connection));
            Visualisation = profile?.Visualisation ?? visualisation;
            Prediction = prediction ?? PredictionSettings.Default;
            Clock = clock ?? ClockSettings.Default;
            Ransac = ransac ?? RansacSettings.Paper;
            ClockEstimator = clockEstimator;
            // Says at once when there is none of that name.
            CreateClockEstimator();
            // Half of what the server bears.
            SyncInterval = SettingRange.RequireMs(syncIntervalMs, 2 * 1000.0 / ProtocolLimits.SyncRequestsPerSecond, 10_000, "sync interval");
        }

        public ConnectionSettings Connection { get; }
        public VisualisationLatency Visualisation { get; }
        public PredictionSettings Prediction { get; }
        public ClockSettings Clock { get; }
        public RansacSettings Ransac { get; }

        /// <summary>One of <see cref="ClockEstimators.Names"/>.</summary>
        public string ClockEstimator { get; }
        public TimeSpan SyncInterval { get; }

        /// <summary>What L_visu comes from; null when it was told as a number.</summary>
        public LatencyProfile Profile { get; }

        public OutsideRangeResponse OutsideRange { get; }

        /// <summary>Null when none is known.</summary>
        public ConstantLatencyRange Range { get; }

        /// <summary>The same for another gateway.</summary>
        public SessionSettings With(ConnectionSettings connection) => new SessionSettings(
            connection, Visualisation, Prediction, Clock, Ransac, SyncInterval.TotalMilliseconds, Range, RewriteBeforeRender, ClockEstimator,
            Profile, OutsideRange);

        /// <summary>A fresh estimator of the chosen kind.</summary>
        internal IClockEstimator CreateClockEstimator() => ClockEstimators.Create(ClockEstimator, Ransac);

        /// <summary>When to exchange, for whoever feeds a session's clock; each caller gets one of its own.</summary>
        /// <param name="random">As of <see cref="ExchangePace"/>.</param>
        internal ExchangePace NewExchangePace(Random random) => new ExchangePace(SyncInterval, Clock.HoldoverAfter, random);

        /// <summary>Whether whoever shows the pose computes and writes it once more right before rendering.</summary>
        public bool RewriteBeforeRender { get; }
    }
}
