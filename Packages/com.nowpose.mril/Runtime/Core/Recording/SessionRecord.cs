using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>
    /// One line of a session file before it is formatted; reused for records of any kind. Numbers that a kind does not use keep the values of an earlier
    /// record.
    /// </summary>
    sealed class SessionRecord
    {
        /// <param name="numbers">Number of values in the largest record.</param>
        public SessionRecord(int numbers) => Numbers = new double[numbers];

        /// <summary>Index in the sequence of all records; set by the ring.</summary>
        public long Place { get; set; }

        public RecordKind Kind { get; set; }

        /// <summary>
        /// Time of a clock, display, statistics, drops or diagnostics record; start of the frame of a frame or object record; arrival of a pose or signal.
        /// </summary>
        public HeadsetTime At { get; set; }

        /// <summary>The sync exchange; used by sync records.</summary>
        public SyncExchange Exchange { get; set; }

        /// <summary>The estimator's decision about the exchange; used by sync records.</summary>
        public SyncVerdict Verdict { get; set; }

        /// <summary>Reason why the exchange is invalid, if it is; used by sync records.</summary>
        public SyncExchangeFault Fault { get; set; }

        /// <summary>A further robot; used by robot records. Referenced, not copied.</summary>
        public RobotModel Robot { get; set; }

        /// <summary>Namespace of the robot; used by robot records.</summary>
        public string Namespace { get; set; }

        /// <summary>The sample; used by sample records. The message is referenced, not copied, because no code modifies it.</summary>
        public Arrival<JointStateMessage> Arrival { get; set; }

        /// <summary>Prefix of the joint names, for a robot other than the one in the header; used by sample and plan records.</summary>
        public string NamePrefix { get; set; }

        /// <summary>Arrival time on the control clock; used by sample, pose and signal records of a gateway's file.</summary>
        public ControlTime? ControlArrival { get; set; }

        /// <summary>The diagnostics, which arrived at <see cref="At"/>; used by diagnostics records. Referenced, not copied.</summary>
        public DiagnosticsMessage Diagnostics { get; set; }

        /// <summary>The plan; used by plan records. Referenced, not copied.</summary>
        public Arrival<JointTrajectoryMessage> Plan { get; set; }

        /// <summary>The received pose of a frame of the cell; used by pose records. The displayed pose in the world; used by object records.</summary>
        public FrameTransform Transform { get; set; }

        /// <summary>Whether the frame does not move; used by pose records.</summary>
        public bool IsStationary { get; set; }

        /// <summary>The value; used by signal records.</summary>
        public SignalValue Signal { get; set; }

        /// <summary>Time stamp of the value; used by signal records.</summary>
        public ControlTime Stamp { get; set; }

        /// <summary>Reason why the message was dropped; None if it was not dropped. Used by sample, plan, pose and signal records.</summary>
        public DropReason Reason { get; set; }

        /// <summary>Display time on the control clock; used by frame and object records.</summary>
        public ControlTime? Light { get; set; }

        /// <summary>State of the pose; used by frame and object records.</summary>
        public PoseState Pose { get; set; }

        /// <summary>Δt_render in frame records, L_visu in display records.</summary>
        public TimeSpan? Length { get; set; }

        /// <summary>Estimated error of the clock offset; used by frame records.</summary>
        public TimeSpan? EstimatedError { get; set; }

        /// <summary>State of the constant-latency range; used by display records.</summary>
        public RangeState Range { get; set; }

        /// <summary>Reprojection mode of the display; used by display records.</summary>
        public ReprojectionMode Reprojection { get; set; }

        /// <summary>The clock model; used by clock and statistics records.</summary>
        public ClockModel Clock { get; set; }

        /// <summary>Whether all samples were discarded; used by clock records.</summary>
        public bool IsNewStart { get; set; }

        /// <summary>
        /// In frame records, displayed joints and then uncompensated joints. In statistics and drops records, values in the order of
        /// <see cref="StatisticsLine"/> and <see cref="DropsLine"/>.
        /// </summary>
        public double[] Numbers { get; }

        /// <summary>Drops the references to messages, which would otherwise stay in memory until the record is used again.</summary>
        public void DropReferences()
        {
            (Robot, Namespace, NamePrefix, Diagnostics) = (null, null, null, null);
            (Arrival, Plan, Transform, Signal) = (default, default, default, default);
        }

        public void SetExchange(in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault) =>
            (Exchange, Verdict, Fault) = (exchange, verdict, fault);

        /// <param name="controlArrival">See <see cref="ControlArrival"/>; null in a headset's file.</param>
        /// <param name="prefix">See <see cref="NamePrefix"/>.</param>
        public void SetSample(in Arrival<JointStateMessage> sample, ControlTime? controlArrival, string prefix, DropReason reason) =>
            (Arrival, ControlArrival, NamePrefix, Reason) = (sample, controlArrival, prefix, reason);

        /// <inheritdoc cref="SetSample" path="/param"/>
        public void SetPlan(in Arrival<JointTrajectoryMessage> plan, string prefix, DropReason reason) =>
            (Plan, NamePrefix, Reason) = (plan, prefix, reason);

        /// <inheritdoc cref="SetSample" path="/param"/>
        public void SetPose(in FrameTransform pose, bool isStationary, HeadsetTime arrival, ControlTime? controlArrival, DropReason reason) =>
            (Transform, IsStationary, At, ControlArrival, Reason) = (pose, isStationary, arrival, controlArrival, reason);

        /// <inheritdoc cref="SetSample" path="/param"/>
        public void SetSignal(in SignalValue signal, ControlTime stamp, HeadsetTime arrival, ControlTime? controlArrival, DropReason reason) =>
            (Signal, Stamp, At, ControlArrival, Reason) = (signal, stamp, arrival, controlArrival, reason);

        public void SetClock(HeadsetTime at, in ClockModel clock, bool isNewStart) => (At, Clock, IsNewStart) = (at, clock, isNewStart);
    }
}
