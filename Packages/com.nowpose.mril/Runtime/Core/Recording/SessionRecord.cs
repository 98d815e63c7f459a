using System;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>
    /// One line of a session file before it is formatted; reused for records of any kind. Properties that a kind does not use keep
    /// values of an earlier record.
    /// </summary>
    sealed class SessionRecord
    {
        /// <param name="numbers">Number of values in the largest record.</param>
        public SessionRecord(int numbers) => Numbers = new double[numbers];

        /// <summary>Index in the sequence of all records; set by the ring.</summary>
        public long Place { get; set; }

        public RecordKind Kind { get; set; }

        /// <summary>Clock, display, statistics, drops and diagnostics: the time. Frame: its start.</summary>
        public HeadsetTime At { get; set; }

        /// <summary>Used by sync.</summary>
        public SyncExchange Exchange { get; set; }

        /// <inheritdoc cref="Exchange"/>
        public SyncVerdict Verdict { get; set; }

        /// <inheritdoc cref="Exchange"/>
        public SyncExchangeFault Fault { get; set; }

        /// <summary>Sample. The message is referenced, not copied, because nothing modifies it.</summary>
        public SampleArrival Arrival { get; set; }

        /// <summary>Sample, in a gateway's file: arrival time on the control clock.</summary>
        public ControlTime? ControlArrival { get; set; }

        /// <summary>Diagnostics. Referenced, not copied; it arrived at <see cref="At"/>.</summary>
        public DiagnosticsMessage Diagnostics { get; set; }

        /// <summary>Plan. Referenced, not copied.</summary>
        public PlanArrival Plan { get; set; }

        /// <summary>Used by sample and plan.</summary>
        public DropReason Reason { get; set; }

        /// <summary>Frame: the display time on the control clock.</summary>
        public ControlTime? Light { get; set; }

        /// <summary>Used by frame.</summary>
        public PoseState Pose { get; set; }

        /// <summary>Frame: Δt_render. Display: L_visu.</summary>
        public TimeSpan? Length { get; set; }

        /// <summary>Frame: the expected error of the clock offset.</summary>
        public TimeSpan? EstimatedError { get; set; }

        /// <summary>Used by display.</summary>
        public RangeState Range { get; set; }

        /// <inheritdoc cref="Range"/>
        public ReprojectionMode Reprojection { get; set; }

        /// <summary>Used by clock and statistics.</summary>
        public ClockModel Clock { get; set; }

        /// <summary>Clock: all samples were discarded.</summary>
        public bool IsNewStart { get; set; }

        /// <summary>
        /// Frame: displayed joints, then held ones. Statistics and drops: in the order of <see cref="StatisticsLine"/> and
        /// <see cref="DropsLine"/>.
        /// </summary>
        public double[] Numbers { get; }
    }
}
