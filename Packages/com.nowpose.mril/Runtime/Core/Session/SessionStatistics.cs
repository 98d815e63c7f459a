using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Network;

namespace Nowpose.Session
{
    /// <summary>How a session does, at one moment. Null stands for "not known yet"; <see cref="CompensationSession.Fill"/> overwrites it all.</summary>
    public sealed class SessionStatistics
    {
        readonly List<JointStatus> _jointStatuses = new List<JointStatus>();
        JointError[] _jointErrors = Array.Empty<JointError>();

        public ClockModel Clock { get; internal set; }

        /// <summary>Φ at the moment of the snapshot.</summary>
        public ClockOffset? Offset { get; internal set; }

        public TimeSpan? RoundTripTime { get; internal set; }

        /// <summary>Steps of a clock since the start.</summary>
        public int ClockSteps { get; internal set; }

        /// <summary>Median of L_app over the newest 200 samples.</summary>
        public TimeSpan? ApplicationLatency { get; internal set; }

        /// <summary>95th percentile of L_app over the newest 200 samples.</summary>
        public TimeSpan? ApplicationLatency95 { get; internal set; }

        /// <summary>Samples that arrived, by the clocks, before they were taken.</summary>
        public long NegativeLatencies { get; internal set; }

        /// <summary>Of the newest frame: as calibrated, or as the runtime predicts it.</summary>
        public TimeSpan VisualisationLatency { get; internal set; }

        /// <summary>What the calibrated L_visu comes from; null when it was told as a number.</summary>
        public LatencyProfile Profile { get; internal set; }

        /// <summary>Whether <see cref="VisualisationLatency"/> is the runtime's prediction.</summary>
        public bool IsLightPredicted { get; internal set; }

        /// <summary>Median of predicted minus calibrated L_visu over the newest 60 frames.</summary>
        public TimeSpan? DisplayTimeDifference { get; internal set; }

        /// <summary>Whether that difference lasts and is too large for both to be right, see <see cref="DisplayTimeCheck"/>.</summary>
        public bool IsDisplayTimeDoubted { get; internal set; }

        /// <summary>Newest answer of the display time source minus its frame's start, used or not; null while there is none.</summary>
        public TimeSpan? DisplayTimeAhead { get; internal set; }

        /// <summary>
        /// Whether the answers have been implausible for a second and not yet plausible for another: in the past, or more than 500 ms ahead.
        /// </summary>
        public bool IsDisplayTimeImplausible { get; internal set; }

        /// <summary>How the display corrects frames for head motion; unknown while nothing reports it.</summary>
        public ReprojectionMode Reprojection { get; internal set; }

        /// <summary>Whether the depth buffer reaches the display; unknown while nothing reports it.</summary>
        public DepthSubmission DepthSubmission { get; internal set; }

        /// <summary>Conditions in which <see cref="Profile"/> was measured and that are different now; empty when nothing differs.</summary>
        public IReadOnlyList<ConditionMismatch> ProfileMismatches { get; internal set; } = Array.Empty<ConditionMismatch>();

        /// <summary>L of Eq. (1), with the median of L_app.</summary>
        public TimeSpan? EndToEndLatency { get; internal set; }

        public TimeSpan? Horizon { get; internal set; }

        /// <summary>Median of Δt_render over the newest 15 frames.</summary>
        public TimeSpan? RenderTime { get; internal set; }

        public RenderTimeSourceKind RenderTimeSource { get; internal set; }

        /// <summary>Whether the visualisation latency is the calibrated one.</summary>
        public RangeState Range { get; internal set; }

        /// <summary>Why <see cref="Range"/> is unknown.</summary>
        internal RangeDoubt RangeDoubt { get; set; }

        /// <summary>
        /// Distance of the displayed tool from where the samples that came later say it was, over the newest ten seconds, mm. What
        /// those samples cannot see is not in it: an error of the clock's offset or of the visualisation latency.
        /// </summary>
        public DisplayedError? ToolError { get; internal set; }

        /// <summary>The same since the session began, or since <see cref="CompensationSession.RestartErrorRun"/>; mm.</summary>
        public DisplayedError? ToolErrorOfRun { get; internal set; }

        /// <summary>The joints that the tool hangs on, from the base on, over the newest ten seconds; rad or m.</summary>
        public IReadOnlyList<JointError> JointErrors => _jointErrors;

        /// <summary>RMS of <see cref="ToolError"/>, mm.</summary>
        public double? ErrorMm => ToolError?.Rms;

        /// <summary>RMS for a headset without compensation, that shows the newest sample; mm.</summary>
        public double? HoldErrorMm => ToolError?.HoldRms;

        /// <summary>Reduction of <see cref="ToolError"/>; null also while the robot rests.</summary>
        public double? ErrorReduction => ToolError?.Reduction;

        public PoseState Pose { get; internal set; }

        /// <summary>Share of the frames of the newest ten seconds in which the pose was current, 0 to 1; null before the first frame.</summary>
        public double? CurrentShare { get; internal set; }

        /// <summary>
        /// Joints that are not live, in the robot's order. A joint that the tool does not depend on is listed only where the gateway
        /// reports it.
        /// </summary>
        public IReadOnlyList<JointStatus> JointStatuses => _jointStatuses;

        /// <summary>What is shown outside the constant-latency range.</summary>
        public OutsideRangeResponse OutsideRange { get; internal set; }

        internal RobotDescriptionMatch RobotDescriptionMatch { get; set; }

        /// <summary>
        /// The first joint whose samples are outside its limits, so that it is drawn elsewhere than it is: another robot's description, or
        /// another unit.
        /// </summary>
        public JointBeyondLimits BeyondLimits { get; internal set; }

        /// <summary>Messages whose samples were used.</summary>
        public long Samples { get; internal set; }

        /// <summary>Messages that were dropped, for whatever reason, and unusable sync exchanges.</summary>
        public long Dropped { get; internal set; }

        public LinkStatus SyncLink { get; internal set; } = LinkStatus.Idle;
        public LinkStatus SampleLink { get; internal set; } = LinkStatus.Idle;
        internal TransportSecurity Security { get; set; }

        internal List<JointStatus> ChangeableJointStatuses => _jointStatuses;

        internal JointError[] PlacesForJointErrors(int count)
        {
            if (_jointErrors.Length != count) _jointErrors = new JointError[count];
            return _jointErrors;
        }
    }
}
