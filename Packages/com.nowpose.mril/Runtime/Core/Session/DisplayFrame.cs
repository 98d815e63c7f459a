using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.DisplayTime;
using Nowpose.Prediction;
using Nowpose.Session.Hindcast;

namespace Nowpose.Session
{
    /// <summary>Data of one displayed frame. The session owns the object and overwrites it at the next tick: read it at once, or copy it.</summary>
    public sealed class DisplayFrame
    {
        readonly JointTracks _tracks;
        readonly RigidTransform[] _linkPoses;
        readonly int _toolLink;
        readonly SettledPose _settled = new SettledPose();

        internal DisplayFrame(JointTracks tracks, RigidTransform[] linkPoses, int toolLink, OutsideRangeResponse outsideRange)
        {
            (_tracks, _linkPoses, _toolLink) = (tracks, linkPoses, toolLink);
            OutsideRange = outsideRange;
        }

        /// <summary>Start of the frame on the headset clock.</summary>
        public HeadsetTime Start { get; private set; }

        /// <summary>Display time on the control clock, to which the joints are predicted; null while the clock is unsynchronised.</summary>
        public ControlTime? DisplayTime { get; private set; }

        /// <summary>Display time minus the newest sample's time; null while either is unknown.</summary>
        public TimeSpan? Horizon { get; private set; }

        /// <summary>Whether the display time is accurate enough to show a pose as current.</summary>
        public bool IsTimeTrusted { get; private set; }

        /// <summary>State of the clock synchronisation in this frame.</summary>
        public ClockState ClockState { get; private set; }

        /// <summary>
        /// Estimated error (±) of <see cref="DisplayTime"/> due to the clock, see <see cref="ClockModel.EstimatedError"/>; zero while the
        /// clock is unsynchronised. Show it when <see cref="Sync.ClockSettings.IsCoarse"/> returns true.
        /// </summary>
        public TimeSpan ClockError { get; private set; }

        public PoseState State { get; private set; }

        /// <summary>The state that the robot's look and the status panel show, see <see cref="SettledPose"/>.</summary>
        internal PoseState SettledState => _settled.Over(State);

        /// <inheritdoc cref="DisplayMoment.IsLast"/>
        internal bool IsLast { get; private set; }

        /// <summary>Whether the robot's moving base, and not one of its joints, is the reason for <see cref="State"/>.</summary>
        internal bool IsLimitedByBase { get; private set; }

        /// <summary>Whether the robot's moving base is the reason for <see cref="SettledState"/>.</summary>
        internal bool IsSettledLimitedByBase { get; private set; }

        /// <summary>
        /// Whether the render time of the previous frames is in the constant-latency range, and they missed no refreshes. Only then is the
        /// display time known.
        /// </summary>
        public RangeState Range { get; private set; }

        /// <inheritdoc cref="DisplayMoment.MissesRefreshes"/>
        internal bool MissesRefreshes { get; private set; }

        /// <summary>Reason why the error of this frame cannot be measured, see <see cref="Hindcast.ErrorWithheldReason"/>.</summary>
        internal ErrorWithheldReason ErrorWithheld { get; private set; }

        /// <summary>How the robot is displayed while <see cref="State"/> is <see cref="PoseState.OutsideRange"/>.</summary>
        public OutsideRangeResponse OutsideRange { get; }

        /// <summary>Whether the runtime's display times contradict the calibration, see <see cref="DisplayTimeCheck"/>.</summary>
        public bool IsDisplayTimeInconsistent { get; private set; }

        [Obsolete("use IsDisplayTimeInconsistent")]
        public bool IsDisplayTimeDoubted => IsDisplayTimeInconsistent;

        /// <summary>Whether the runtime's display times have been implausible for a second, see <see cref="SessionChange"/>.</summary>
        public bool IsDisplayTimeImplausible { get; private set; }

        /// <summary>Displayed joint positions, one per moving joint in the robot's order, rad or m, including mimic joints.</summary>
        public ReadOnlySpan<double> Joints => _tracks.Positions;

        /// <summary>Method by which each position of <see cref="Joints"/> was computed.</summary>
        public ReadOnlySpan<PredictionKind> Kinds => _tracks.Kinds;

        /// <summary>Joint positions that a headset without compensation would show: the newest samples.</summary>
        public ReadOnlySpan<double> HeldJoints => _tracks.Held;

        /// <summary>Poses of all links in the robot's base frame, right-handed, metres, in the order of the robot's links.</summary>
        public ReadOnlySpan<RigidTransform> LinkPoses => _linkPoses;

        /// <summary>Pose of the tool centre point, or of the flange if the robot has no tool, in the robot's base frame.</summary>
        public ref readonly RigidTransform ToolPose => ref _linkPoses[_toolLink];

        internal void Set(in DisplayMoment moment, TimeSpan? horizon, PoseState state)
        {
            Start = moment.Start;
            DisplayTime = moment.DisplayTime;
            Horizon = horizon;
            IsTimeTrusted = moment.IsTrusted;
            ClockState = moment.Clock.State;
            ClockError = moment.Clock.EstimatedError;
            IsLast = moment.IsLast;
            Range = moment.Range;
            MissesRefreshes = moment.MissesRefreshes;
            ErrorWithheld = moment.ErrorWithheld;
            IsDisplayTimeInconsistent = moment.IsInconsistent;
            IsDisplayTimeImplausible = moment.IsImplausible;
            SetState(state, isLimitedByBase: false);
        }

        /// <summary>Sets the state of the robot's moving base. A robot whose base is not current is not displayed at its real position.</summary>
        internal void SetBase(PoseState state)
        {
            if (state < State) SetState(state, isLimitedByBase: true);
        }

        void SetState(PoseState state, bool isLimitedByBase)
        {
            (State, IsLimitedByBase) = (state, isLimitedByBase);
            _settled.Add(Start, state);
            if (SettledState == state) IsSettledLimitedByBase = isLimitedByBase;
        }
    }
}
