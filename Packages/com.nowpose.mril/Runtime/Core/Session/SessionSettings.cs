using System;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>
    /// How the robot is displayed while the render time is outside the constant-latency range, or frames miss refreshes of the display, so that
    /// frames appear later than calibrated.
    /// The state is always <see cref="PoseState.OutsideRange"/>, and text and stripes distinguish the pose from a current pose.
    /// </summary>
    public enum OutsideRangeResponse
    {
        /// <summary>The robot is fainter; its pose is computed as usual.</summary>
        Fade,

        /// <summary>The robot fades only as much as with any other striped pose; its pose is computed as usual.</summary>
        GoOn,

        /// <summary>The robot is as faint as a held pose and shows the newest samples without compensation.</summary>
        Hold,
    }

    /// <summary>Constant settings of a session. Immutable; values that adapt at run time are part of the session's state.</summary>
    public sealed class SessionSettings
    {
        /// <param name="connection">Connection to the gateway.</param>
        /// <param name="visualisation">Initial L_visu of this device.</param>
        /// <param name="prediction">Settings of the prediction; null for the defaults.</param>
        /// <param name="clock">Settings of the clock; null for the defaults.</param>
        /// <param name="ransac">Constants of the paper's clock estimator, used if it is selected; null for the paper's values.</param>
        /// <param name="syncIntervalMs">
        /// Interval from the start of one sync exchange to the start of the next, ms; the server allows 100 requests per second. The interval is as
        /// short as a quarter of this value after the connection and after a step, and as long as five times this value on a quiet network; see
        /// <see cref="ExchangePace"/>.
        /// </param>
        /// <param name="range">The constant-latency range of this device; null when it is unknown.</param>
        /// <param name="clockEstimator">Name of the clock estimator, one of <see cref="ClockEstimators.Names"/>.</param>
        /// <param name="profile">
        /// Profile whose L_visu replaces <paramref name="visualisation"/> and whose range, if it has one, replaces <paramref name="range"/>; null without
        /// a profile.
        /// </param>
        /// <param name="outsideRange">How the robot is displayed while its state is <see cref="PoseState.OutsideRange"/>.</param>
        /// <param name="rewriteBeforeRender">
        /// Value of <see cref="RewriteBeforeRender"/>; true for a headset. Calibrate L_visu with the same setting.
        /// </param>
        /// <param name="robotNamespace">Value of <see cref="RobotNamespace"/>.</param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public SessionSettings(
            ConnectionSettings connection, VisualisationLatency visualisation, PredictionSettings prediction = null,
            ClockSettings clock = null, RansacSettings ransac = null, double syncIntervalMs = ProtocolLimits.SyncIntervalMs,
            ConstantLatencyRange range = null, bool rewriteBeforeRender = false,
            string clockEstimator = ClockEstimators.Default, LatencyProfile profile = null,
            OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade, string robotNamespace = "")
        {
            RobotNamespace = string.IsNullOrEmpty(robotNamespace) ? "" : RobotTopic.RequireNamespace(robotNamespace);
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
            // Throws an exception at construction, and not at the first use, if the name is unknown.
            CreateClockEstimator();
            // The minimum interval corresponds to half the request rate that the server allows.
            SyncInterval = SettingRange.RequireMs(syncIntervalMs, 2 * 1000.0 / ProtocolLimits.SyncRequestsPerSecond, 10_000, "sync interval");
        }

        public ConnectionSettings Connection { get; }

        /// <summary>Namespace of the robot in the cell, such as arm1 for the topic /arm1/joint_states; empty if the robot has none.</summary>
        public string RobotNamespace { get; }

        public VisualisationLatency Visualisation { get; }
        public PredictionSettings Prediction { get; }
        public ClockSettings Clock { get; }
        public RansacSettings Ransac { get; }

        /// <summary>Name of the clock estimator, one of <see cref="ClockEstimators.Names"/>.</summary>
        public string ClockEstimator { get; }
        public TimeSpan SyncInterval { get; }

        /// <summary>Whether all sync exchanges have the interval <see cref="SyncInterval"/>, as in the paper.</summary>
        internal bool IsSyncIntervalConstant { get; private set; }

        /// <summary>Profile of L_visu; null if the value was set as a number.</summary>
        public LatencyProfile Profile { get; }

        public OutsideRangeResponse OutsideRange { get; }

        /// <summary>The constant-latency range; null when it is unknown.</summary>
        public ConstantLatencyRange Range { get; }

        /// <summary>Returns the same settings for another gateway.</summary>
        public SessionSettings With(ConnectionSettings connection) => new SessionSettings(
            connection, Visualisation, Prediction, Clock, Ransac, SyncInterval.TotalMilliseconds, Range, RewriteBeforeRender, ClockEstimator,
            Profile, OutsideRange, RobotNamespace)
        {
            IsSyncIntervalConstant = IsSyncIntervalConstant,
        };

        /// <summary>Returns the same settings with one sync exchange per <see cref="SyncInterval"/> at all times, as in the paper.</summary>
        internal SessionSettings WithConstantSyncInterval()
        {
            var constant = With(Connection);
            constant.IsSyncIntervalConstant = true;
            return constant;
        }

        /// <summary>Creates a new estimator of the selected kind.</summary>
        internal IClockEstimator CreateClockEstimator() => ClockEstimators.Create(ClockEstimator, Ransac);

        /// <summary>Creates a schedule of sync exchanges. Each call returns a new object.</summary>
        /// <param name="random">Source of random numbers, see <see cref="ExchangePace"/>.</param>
        internal ExchangePace NewExchangePace(Random random) => new ExchangePace(SyncInterval, Clock.HoldoverAfter, random, IsSyncIntervalConstant);

        /// <summary>Whether the pose is computed and applied again right before rendering.</summary>
        public bool RewriteBeforeRender { get; }
    }
}
