using System;
using Nowpose.Anchoring;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Unity.Messages
{
    /// <summary>Values and reasons that the status panel shows.</summary>
    static class StatusMessages
    {
        /// <summary>Labels of the rows of the status panel, in the order of <see cref="Nowpose.Unity.Status.StatusRow"/>.</summary>
        public static readonly string[] Labels =
        {
            "Pose", "Clock", "L_app", "L_visu", "Horizon", "Render time", "Range", "Error reduction", "Residual error", "Gateway", "Robot", "Base",
            "Objects", "", "", "", "", "", "", "",
        };

        public const string NoSession = "no session";
        public const string NoRig = "no rig";
        public const string NotPlaced = "not placed";
        public const string ClockNotSynchronised = "clock not synchronised";
        public const string ClockPrefix = "clock ± ";
        public const string PercentilePrefix = "95 % below ";
        public const string OffsetSuffix = " mm off";
        public const string LockedByHand = "by hand";
        public const string OutsideRange = "! outside";
        public const string InsideRange = "inside";
        public const string BeyondLimits = "! beyond its limits";
        public const string SameRobot = "same as gateway's";
        public const string OtherRobot = "! differs";
        public const string LatencyImplausible = "implausible display times";
        public const string LatencySet = "as set";
        public const string LatenciesDiffer = "runtime and calibration differ";
        public const string LatencyPredicted = "predicted by the runtime";
        public const string LatencyNotVerified = "predicted, not verified";
        public const string FramesLate = "frames are late";
        public const string TooFewSamples = "too few recent samples";
        public const string JointWithoutSamples = "a joint has no samples";
        public const string BaseNotCurrent = "its base is not current";
        public const string RobotNotAdded = "not added to the session; the log states the reason";
        public const string NoLimit = "no limit is known";

        public static string Spread(double millimetres, double degrees) =>
            FormattableString.Invariant($"spread {millimetres:0.0} mm {degrees:0.0}°");

        public static string Of(ClockState state)
        {
            switch (state)
            {
                case ClockState.Synchronised: return "synchronised";
                case ClockState.Coarse: return "coarse";
                case ClockState.Converging: return "! converging";
                case ClockState.Holdover: return "! holdover";
                default: return "! no response yet";
            }
        }

        public static string Of(BaseAnchorState state)
        {
            switch (state)
            {
                case BaseAnchorState.Placed: return "placed by hand";
                case BaseAnchorState.Searching: return "! not locked";
                case BaseAnchorState.Restored: return "! not confirmed";
                case BaseAnchorState.Moved: return "! moved";
                case BaseAnchorState.Lost: return "! lost";
                default: return "locked";
            }
        }

        /// <returns>Null if the render time determines the range.</returns>
        public static string Of(RangeUnknownReason reason)
        {
            switch (reason)
            {
                case RangeUnknownReason.NoLimit: return NoLimit;
                case RangeUnknownReason.NoRenderTime: return "not measured";
                case RangeUnknownReason.TooFewFrames: return "measuring";
                case RangeUnknownReason.OtherSource: return StateNames.OtherSourceLimit;
                case RangeUnknownReason.LongerThanRefresh:
                case RangeUnknownReason.LowFrameRate: return StateNames.FramesMissRefreshes;
                case RangeUnknownReason.BeyondMeasured: return StateNames.BeyondMeasured;
                default: return null;
            }
        }

        /// <summary>Describes the connection that is in the worse state: the sync connection or the sample connection.</summary>
        public static string Of(LinkState sync, LinkState samples)
        {
            if (sync == LinkState.Idle && samples == LinkState.Idle) return "not connected";
            if (sync == LinkState.Waiting || samples == LinkState.Waiting) return "! trying again";
            return sync == LinkState.Connected && samples == LinkState.Connected ? "connected" : "connecting";
        }

        /// <param name="isLocal">Whether the gateway is on the headset's own machine.</param>
        public static string Of(TransportSecurity security, bool isLocal)
        {
            switch (security)
            {
                case TransportSecurity.Pinned: return "encrypted, pinned key";
                case TransportSecurity.DeviceTrust: return "encrypted, device trust";
                default: return isLocal ? "within this machine" : "! not encrypted";
            }
        }

        /// <param name="time">Time of day or date.</param>
        public static string Since(string time) => "since " + time;

        public static string NotCurrent(int count) => "! " + count + " not current";
        public static string FurtherParts(int count) => "! and " + count + " more";

        /// <summary>Returns the reason why a robot's pose is not current; empty if it is current.</summary>
        /// <param name="isLimitedByBase">Whether the robot's moving base is the reason.</param>
        public static string ReasonOf(PoseState pose, bool isLimitedByBase = false)
        {
            if (isLimitedByBase) return BaseNotCurrent;
            switch (pose)
            {
                case PoseState.Current: return "";
                case PoseState.OutsideRange: return FramesLate;
                case PoseState.Held: return TooFewSamples;
                case PoseState.Unsynchronised: return "time not known";
                default: return JointWithoutSamples;
            }
        }
    }
}
