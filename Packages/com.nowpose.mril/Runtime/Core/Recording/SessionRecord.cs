using System;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Recording
{
    /// <summary>
    /// One line of a session file before it is text: room for any kind, used again and again. What a kind does not name keeps an
    /// earlier record's value.
    /// </summary>
    sealed class SessionRecord
    {
        /// <param name="numbers">How many numbers the greatest record has.</param>
        public SessionRecord(int numbers) => Numbers = new double[numbers];

        /// <summary>Place among all records of the ring, which owns it.</summary>
        public long Place { get; set; }

        public RecordKind Kind { get; set; }

        /// <summary>Clock, display, statistics, drops and diagnostics: when. Frame: its start.</summary>
        public HeadsetTime At { get; set; }

        /// <summary>Sync.</summary>
        public SyncExchange Exchange { get; set; }

        /// <inheritdoc cref="Exchange"/>
        public SyncVerdict Verdict { get; set; }

        /// <inheritdoc cref="Exchange"/>
        public SyncExchangeFault Fault { get; set; }

        /// <summary>Sample. The message is kept, not copied: nobody writes into it.</summary>
        public SampleArrival Arrival { get; set; }

        /// <summary>Sample, in a gateway's file: when it arrived, on the control clock.</summary>
        public ControlTime? ControlArrival { get; set; }

        /// <summary>Diagnostics. Kept, likewise; arrived at <see cref="At"/>.</summary>
        public DiagnosticsMessage Diagnostics { get; set; }

        /// <summary>Plan. Kept, likewise.</summary>
        public PlanArrival Plan { get; set; }

        /// <summary>Sample, plan.</summary>
        public DropReason Reason { get; set; }

        /// <summary>Frame: the moment of light.</summary>
        public ControlTime? Light { get; set; }

        /// <summary>Frame.</summary>
        public PoseState Pose { get; set; }

        /// <summary>Frame: Δt_render. Display: L_visu.</summary>
        public TimeSpan? Length { get; set; }

        /// <summary>Frame: the expected error of the clock offset.</summary>
        public TimeSpan? EstimatedError { get; set; }

        /// <summary>Display.</summary>
        public RangeState Range { get; set; }

        /// <inheritdoc cref="Range"/>
        public ReprojectionMode Reprojection { get; set; }

        /// <summary>Clock, statistics.</summary>
        public ClockModel Clock { get; set; }

        /// <summary>Clock: all samples were forgotten.</summary>
        public bool IsNewStart { get; set; }

        /// <summary>
        /// Frame: displayed joints, then held ones. Statistics and drops: in the order of <see cref="StatisticsLine"/> and
        /// <see cref="DropsLine"/>.
        /// </summary>
        public double[] Numbers { get; }
    }
}
