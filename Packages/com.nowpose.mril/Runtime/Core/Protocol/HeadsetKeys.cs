namespace Nowpose.Protocol
{
    /// <summary>
    /// Keys of the diagnostics that a headset publishes. The name of a quantity ends with its unit; a key that ends with a slash is the prefix of a name.
    /// </summary>
    /// <remarks>The gateway and its operations page read them. A test compares the keys in <c>Web/src/operations/headsetKeys.ts</c> with this list.</remarks>
    static class HeadsetKeys
    {
        public const string Version = "version";

        // The clock, headset time minus control time.
        public const string State = "state";
        public const string OffsetNs = "offset_ns";
        public const string SkewPpm = "skew_ppm";
        public const string ErrorBoundUs = "error_bound_us";
        public const string EstimatedErrorUs = "estimated_error_us";
        public const string RoundTripMs = "rtt_ms";

        // The pose, and what it is computed from.
        public const string Pose = "pose";
        public const string CurrentShare = "current_share";
        public const string MissingJoints = "missing_joints";
        public const string JointStatus = "joint_status/";
        public const string ObjectsNotCurrent = "objects_not_current";
        public const string SignalsNotCurrent = "signals_not_current";
        public const string ObjectStatus = "object_status/";
        public const string SignalStatus = "signal_status/";
        public const string BeyondLimits = "beyond_limits";
        public const string DescriptionDiffers = "description_differs";
        public const string Samples = "samples";
        public const string Dropped = "dropped";

        // Latencies and the display.
        public const string ApplicationLatencyMs = "l_app_ms";
        public const string VisualisationLatencyMs = "l_visu_ms";
        public const string HorizonMs = "horizon_ms";
        public const string RenderMs = "render_ms";
        public const string Range = "range";
        public const string DisplayTime = "display_time";
        public const string DisplayTimeAheadMs = "display_time_ahead_ms";
        public const string DisplayTimeDifferenceMs = "display_time_difference_ms";
        public const string Reprojection = "reprojection";
        public const string DepthSubmission = "depth_submission";
        public const string ProfileMismatch = "profile_mismatch";

        // Errors of the tool (RMS and P95), with compensation and without it (hold), and their uncertainties.
        public const string ErrorWithheld = "error_withheld";
        public const string ErrorMm = "error_mm";
        public const string ErrorMmHold = "error_mm_hold";
        public const string ErrorMmP95 = "error_mm_p95";
        public const string ErrorMmHoldP95 = "error_mm_hold_p95";
        public const string ErrorMmTruth = "error_mm_truth";
        public const string ErrorMmClock = "error_mm_clock";
        public const string Reduction = "reduction";
        public const string ReductionUncertainty = "reduction_uncertainty";

        // The same for each joint, rad or m.
        public const string JointError = "error/";
        public const string JointErrorP95 = "error_p95/";
        public const string JointErrorHold = "error_hold/";
        public const string JointErrorHoldP95 = "error_hold_p95/";
        public const string JointReduction = "reduction/";
        public const string JointReductionUncertainty = "reduction_uncertainty/";
    }
}
