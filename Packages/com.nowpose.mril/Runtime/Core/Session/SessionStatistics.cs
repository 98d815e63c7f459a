using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Network;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>
    /// Measurements of a session at one time. A value is null while it is unknown. <see cref="CompensationSession.Fill"/> overwrites all values.
    /// </summary>
    public sealed class SessionStatistics
    {
        readonly RobotStatistics _robot = new RobotStatistics();
        readonly List<RobotStatistics> _otherRobots = new List<RobotStatistics>();
        JointError[] _jointErrors = Array.Empty<JointError>();

        /// <summary>Control time of the measurements; null while the clock is unsynchronised.</summary>
        internal ControlTime? Now { get; set; }

        public ClockModel Clock { get; internal set; }

        /// <summary>See <see cref="CompensationSession.VersionMismatch"/>.</summary>
        internal string VersionMismatch { get; set; }

        internal ClockSettings ClockSettings { get; set; } = ClockSettings.Default;

        /// <summary>
        /// Whether, according to the session's settings, a display that uses <see cref="Clock"/> must also show the estimated error of the clock.
        /// </summary>
        internal bool IsClockCoarse => ClockSettings.IsCoarse(Clock);

        /// <summary>Offset Φ of the clocks at the time of the measurements.</summary>
        public ClockOffset? Offset { get; internal set; }

        public TimeSpan? RoundTripTime { get; internal set; }

        /// <summary>Number of clock steps since the start.</summary>
        public int ClockSteps { get; internal set; }

        /// <summary>Median of L_app over the newest 200 samples.</summary>
        public TimeSpan? ApplicationLatency { get; internal set; }

        /// <summary>95th percentile of L_app over the newest 200 samples.</summary>
        public TimeSpan? ApplicationLatency95 { get; internal set; }

        /// <summary>Number of samples whose time stamp is later than their arrival.</summary>
        public long NegativeLatencies { get; internal set; }

        /// <summary>L_visu of the newest frame: the calibrated value or the runtime's prediction.</summary>
        public TimeSpan VisualisationLatency { get; internal set; }

        /// <summary>Profile of the calibrated L_visu; null if the value was set as a number.</summary>
        public LatencyProfile Profile { get; internal set; }

        /// <summary>Whether <see cref="VisualisationLatency"/> is the runtime's prediction.</summary>
        public bool IsLightPredicted { get; internal set; }

        /// <summary>Median of predicted minus calibrated L_visu over the newest 60 frames.</summary>
        public TimeSpan? DisplayTimeDifference { get; internal set; }

        /// <summary>Whether <see cref="DisplayTimeDifference"/> has been too large for some time, see <see cref="DisplayTimeCheck"/>.</summary>
        public bool IsDisplayTimeInconsistent { get; internal set; }

        [Obsolete("use IsDisplayTimeInconsistent")]
        public bool IsDisplayTimeDoubted => IsDisplayTimeInconsistent;

        /// <summary>
        /// Newest display time from the source minus the start of its frame, even if the session did not use this time; null if there is none.
        /// </summary>
        public TimeSpan? DisplayTimeAhead { get; internal set; }

        /// <summary>
        /// Whether the source's display times have been implausible for a second (in the past, or more than 500 ms ahead) and are not yet
        /// plausible again.
        /// </summary>
        public bool IsDisplayTimeImplausible { get; internal set; }

        /// <summary>Reprojection mode of the display; unknown when it is not reported.</summary>
        public ReprojectionMode Reprojection { get; internal set; }

        /// <summary>Whether the depth buffer reaches the display; unknown when it is not reported.</summary>
        public DepthSubmission DepthSubmission { get; internal set; }

        /// <summary>Conditions that differ from those under which <see cref="Profile"/> was measured; empty if none differ.</summary>
        public IReadOnlyList<ConditionMismatch> ProfileMismatches { get; internal set; } = Array.Empty<ConditionMismatch>();

        /// <summary>L of Eq. (1), with the median of L_app.</summary>
        public TimeSpan? EndToEndLatency { get; internal set; }

        public TimeSpan? Horizon { get; internal set; }

        /// <summary>Median of Δt_render over the newest 15 frames.</summary>
        public TimeSpan? RenderTime { get; internal set; }

        public RenderTimeSourceKind RenderTimeSource { get; internal set; }

        /// <summary>Whether L_visu has its calibrated value.</summary>
        public RangeState Range { get; internal set; }

        /// <summary>Reason why <see cref="Range"/> is unknown, or outside at any render time.</summary>
        internal RangeUnknownReason RangeUnknownReason { get; set; }

        /// <summary>
        /// Error of the displayed tool relative to its true position from later samples, over the last ten seconds, mm. Excludes errors
        /// that these samples cannot show: errors of the clock's offset and of L_visu. Null while L_visu may differ from the calibrated
        /// value: <see cref="Range"/> is outside, or a limit is known but cannot be monitored.
        /// </summary>
        public DisplayedError? ToolError { get; internal set; }

        /// <summary>
        /// Error of the displayed tool since the session began, or since <see cref="CompensationSession.RestartErrorRun"/>, mm. Null under the
        /// conditions of <see cref="ToolError"/>, and if L_visu may have differed from its calibrated value since then.
        /// </summary>
        public DisplayedError? ToolErrorOfRun { get; internal set; }

        /// <summary>Reason why <see cref="ToolError"/> and <see cref="JointErrors"/> are withheld.</summary>
        internal ErrorWithheldReason ErrorWithheld { get; set; }

        /// <summary>Reason why <see cref="ToolErrorOfRun"/> is withheld.</summary>
        internal ErrorWithheldReason ErrorOfRunWithheld { get; set; }

        /// <summary>Errors of the joints between base and tool over the last ten seconds, in order from the base; rad or m.</summary>
        public IReadOnlyList<JointError> JointErrors => _jointErrors;

        /// <summary>RMS of <see cref="ToolError"/>, mm.</summary>
        public double? ErrorMm => ToolError?.Rms;

        /// <summary>RMS error of the tool without compensation, which shows the newest sample unchanged; mm.</summary>
        public double? HoldErrorMm => ToolError?.HoldRms;

        /// <summary>
        /// Reduction of the tool error, see <see cref="DisplayedError"/>. Null if <see cref="ToolError"/> is null, and while the robot is at rest.
        /// </summary>
        public double? ErrorReduction => ToolError?.Reduction;

        /// <summary>State of the pose of <see cref="CompensationSession.Robot"/>.</summary>
        public PoseState Pose { get => _robot.Pose; internal set => _robot.Pose = value; }

        /// <inheritdoc cref="DisplayFrame.SettledState"/>
        internal PoseState SettledPose { get => _robot.SettledPose; set => _robot.SettledPose = value; }

        /// <inheritdoc cref="DisplayFrame.IsSettledLimitedByBase"/>
        internal bool IsSettledLimitedByBase { get => _robot.IsSettledLimitedByBase; set => _robot.IsSettledLimitedByBase = value; }

        /// <summary>The most severe state among the poses of all displayed robots.</summary>
        internal PoseState WorstPose { get; set; }

        /// <inheritdoc cref="SessionRobots.FramesMissingFor"/>
        internal TimeSpan? FramesMissingFor { get; set; }

        /// <summary>
        /// Fraction of the frames of the last ten seconds in which the poses of all robots were current, 0 to 1; null before the first frame.
        /// </summary>
        public double? CurrentShare { get; internal set; }

        /// <summary>
        /// Joints that are not live, in the robot's order. A joint that does not move the tool is listed only if the gateway
        /// reports it.
        /// </summary>
        public IReadOnlyList<JointStatus> JointStatuses => _robot.JointStatuses;

        /// <summary>How the robot is displayed outside the constant-latency range.</summary>
        public OutsideRangeResponse OutsideRange { get; internal set; }

        internal RobotDescriptionMatch RobotDescriptionMatch { get => _robot.DescriptionMatch; set => _robot.DescriptionMatch = value; }

        /// <summary>
        /// First joint with samples outside its limits, which is drawn at the limit; null if there is none. A possible cause is that the description
        /// belongs to another robot, or that the samples have another unit.
        /// </summary>
        public JointBeyondLimits BeyondLimits { get => _robot.BeyondLimits; internal set => _robot.BeyondLimits = value; }

        /// <summary>Number of used messages.</summary>
        public long Samples { get => _robot.Samples; internal set => _robot.Samples = value; }

        /// <summary>Number of dropped messages and dropped sync exchanges.</summary>
        public long Dropped { get; internal set; }

        public LinkStatus SyncLink { get; internal set; } = LinkStatus.Idle;
        public LinkStatus SampleLink { get; internal set; } = LinkStatus.Idle;
        internal TransportSecurity Security { get; set; }

        /// <summary>State of <see cref="CompensationSession.Robot"/>.</summary>
        internal RobotStatistics OwnRobot => _robot;

        /// <summary>States of the displayed robots other than <see cref="CompensationSession.Robot"/>.</summary>
        internal IReadOnlyList<RobotStatistics> OtherRobots => _otherRobots;

        /// <summary>States of all displayed robots; allocates.</summary>
        internal IEnumerable<RobotStatistics> Robots => _otherRobots.Prepend(_robot);

        /// <summary>Writes the states of all robots.</summary>
        internal void Fill(SessionRobots robots, HeadsetTime now)
        {
            FramesMissingFor = robots.FramesMissingFor(now);
            WorstPose = robots.WorstPoseAt(now);
            robots[0].Fill(_robot, now, Clock);
            var shown = 0;
            for (var i = 1; i < robots.Count; i++)
            {
                if (!robots[i].IsShown) continue;
                if (shown == _otherRobots.Count) _otherRobots.Add(new RobotStatistics());
                robots[i].Fill(_otherRobots[shown++], now, Clock);
            }
            _otherRobots.RemoveRange(shown, _otherRobots.Count - shown);
        }

        internal JointError[] PlacesForJointErrors(int count)
        {
            if (_jointErrors.Length != count) _jointErrors = new JointError[count];
            return _jointErrors;
        }
    }
}
