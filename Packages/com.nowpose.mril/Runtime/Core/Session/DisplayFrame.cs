using System;
using Nowpose.Frames;
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
        readonly ForwardKinematics _kinematics;
        readonly RigidTransform[] _linkPoses;
        readonly RigidTransform[] _heldLinkPoses;
        readonly int _toolLink;
        readonly int[] _toolJoints;
        double[] _positionsAt;
        RigidTransform[] _linkPosesAt;
        bool _isHeldComputed;

        internal DisplayFrame(RobotModel robot, JointTracks tracks, OutsideRangeResponse outsideRange)
        {
            OutsideRange = outsideRange;
            _tracks = tracks;
            _kinematics = new ForwardKinematics(robot);
            _linkPoses = new RigidTransform[robot.Links.Count];
            _heldLinkPoses = new RigidTransform[robot.Links.Count];
            _toolLink = robot.IndexOfLink(robot.ToolLink.Name);
            _toolJoints = ToolJoints.Of(robot);
        }

        /// <summary>Start of the frame on the headset clock.</summary>
        public HeadsetTime Start { get; private set; }

        /// <summary>Display time on the control clock, to which joints are predicted; null while the clock is unsynchronised.</summary>
        public ControlTime? DisplayTime { get; private set; }

        /// <summary>Display time minus the newest sample's time; null while either is unknown.</summary>
        public TimeSpan? Horizon { get; private set; }

        /// <summary>Whether the display time is accurate enough to show a pose as current.</summary>
        public bool IsTimeTrusted { get; private set; }

        /// <summary>State of the clock synchronisation in this frame.</summary>
        public ClockState ClockState { get; private set; }

        /// <summary>
        /// Estimated error of <see cref="DisplayTime"/> due to the clock, in both directions, see
        /// <see cref="ClockModel.EstimatedError"/>; zero while the clock is unsynchronised. Show it when
        /// <see cref="Sync.ClockSettings.IsCoarse"/> returns true.
        /// </summary>
        public TimeSpan ClockError { get; private set; }

        public PoseState State { get; private set; }

        /// <summary>Whether the render time of the previous frames is in the range in which the display time is known.</summary>
        public RangeState Range { get; private set; }

        /// <summary>Why the error of this frame cannot be measured: it may appear at another time than <see cref="DisplayTime"/>.</summary>
        internal ErrorWithheldReason ErrorWithheld { get; private set; }

        /// <summary>Display of the robot while <see cref="State"/> is <see cref="PoseState.OutsideRange"/>.</summary>
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

        /// <param name="isJointReportedMissing">Whether the gateway reports that a joint of the robot has no data.</param>
        internal void Update(in DisplayMoment moment, bool isJointReportedMissing)
        {
            ClockState = moment.Clock.State;
            ClockError = moment.Clock.EstimatedError;
            IsDisplayTimeInconsistent = moment.IsInconsistent;
            IsDisplayTimeImplausible = moment.IsImplausible;
            ErrorWithheld = moment.ErrorWithheld;
            Start = moment.Start;
            IsTimeTrusted = moment.IsTrusted;
            Range = moment.Range;
            DisplayTime = moment.DisplayTime;
            if (moment.DisplayTime is ControlTime light) _tracks.Predict(light);
            else _tracks.Hold();
            Horizon = DisplayTime - _tracks.Newest;
            State = JudgeState(isJointReportedMissing);
            // After the state is determined: a pose that is held on purpose is not stale.
            if (State == PoseState.OutsideRange && OutsideRange == OutsideRangeResponse.Hold) _tracks.Hold();
            _kinematics.Compute(_tracks.Positions, _linkPoses);
            _isHeldComputed = false;
        }

        /// <summary>Returns <see cref="LinkPoses"/> for <see cref="HeldJoints"/>; computed on the first call of a frame.</summary>
        internal ReadOnlySpan<RigidTransform> HeldLinkPoses()
        {
            if (!_isHeldComputed) _kinematics.Compute(_tracks.Held, _heldLinkPoses);
            _isHeldComputed = true;
            return _heldLinkPoses;
        }

        /// <summary>Returns the pose of a link in the robot's base frame at any time for which there are samples or a prediction.</summary>
        /// <param name="origin">That of the joints up to the tool.</param>
        internal RigidTransform LinkPoseAt(int link, ControlTime at, out PoseOrigin origin)
        {
            MakeScratch();
            origin = _tracks.At(at, _toolJoints, _positionsAt);
            _kinematics.Compute(_positionsAt, _linkPosesAt);
            return _linkPosesAt[link];
        }

        /// <summary>Returns the tool's planned pose in the robot's base frame at a time, however far ahead.</summary>
        /// <returns>False if a joint up to the tool follows no plan at that time.</returns>
        internal bool TryPlanTool(ControlTime at, out RigidTransform tool)
        {
            MakeScratch();
            var isPlanned = _tracks.TryPlan(at, _toolJoints, _positionsAt);
            if (isPlanned) _kinematics.Compute(_positionsAt, _linkPosesAt);
            tool = isPlanned ? _linkPosesAt[_toolLink] : RigidTransform.Identity;
            return isPlanned;
        }

        void MakeScratch()
        {
            _positionsAt ??= new double[_tracks.Positions.Length];
            _linkPosesAt ??= new RigidTransform[_linkPoses.Length];
        }

        PoseState JudgeState(bool isJointReportedMissing)
        {
            var held = isJointReportedMissing;
            var kinds = _tracks.Kinds;
            foreach (var joint in _toolJoints)
            {
                if (kinds[joint] == PredictionKind.None) return PoseState.Incomplete;
                held |= kinds[joint] == PredictionKind.Held;
            }
            if (!IsTimeTrusted) return PoseState.Unsynchronised;
            if (held) return PoseState.Held;
            return Range == RangeState.Outside ? PoseState.OutsideRange : PoseState.Current;
        }
    }
}
