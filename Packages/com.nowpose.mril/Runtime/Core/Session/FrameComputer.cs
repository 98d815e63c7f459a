using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>Computes a robot's displayed frame: predicts the joints to the display time, judges the pose, and computes the links.</summary>
    sealed class FrameComputer
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

        public FrameComputer(RobotModel robot, JointTracks tracks, OutsideRangeResponse outsideRange)
        {
            _tracks = tracks;
            _kinematics = new ForwardKinematics(robot);
            _linkPoses = new RigidTransform[robot.Links.Count];
            _heldLinkPoses = new RigidTransform[robot.Links.Count];
            _toolLink = robot.IndexOfLink(robot.ToolLink.Name);
            _toolJoints = ToolJoints.Of(robot);
            Frame = new DisplayFrame(tracks, _linkPoses, _toolLink, outsideRange);
        }

        /// <summary>The newest frame, which <see cref="Compute"/> overwrites.</summary>
        public DisplayFrame Frame { get; }

        /// <param name="isJointReportedMissing">Whether the gateway reports that a joint of the robot has no data.</param>
        public void Compute(in DisplayMoment moment, bool isJointReportedMissing)
        {
            if (moment.DisplayTime is ControlTime light) _tracks.Predict(light);
            else _tracks.Hold();
            var state = StateAt(moment, isJointReportedMissing);
            Frame.Set(moment, moment.DisplayTime - _tracks.Newest, state);
            // After the state is determined: a pose that is held on purpose is not stale.
            if (state == PoseState.OutsideRange && Frame.OutsideRange == OutsideRangeResponse.Hold) _tracks.Hold();
            _kinematics.Compute(_tracks.Positions, _linkPoses);
            _isHeldComputed = false;
        }

        /// <summary>Returns <see cref="DisplayFrame.LinkPoses"/> for <see cref="DisplayFrame.HeldJoints"/>; computed on the first call of a frame.</summary>
        public RigidTransform[] HeldLinkPoses()
        {
            if (!_isHeldComputed) _kinematics.Compute(_tracks.Held, _heldLinkPoses);
            _isHeldComputed = true;
            return _heldLinkPoses;
        }

        /// <summary>Returns the pose of a link in the robot's base frame at any time for which there are samples or a prediction.</summary>
        /// <param name="origin">That of the joints up to the tool.</param>
        public RigidTransform LinkPoseAt(int link, ControlTime at, out PoseOrigin origin)
        {
            MakeScratch();
            origin = _tracks.At(at, _toolJoints, _positionsAt);
            _kinematics.Compute(_positionsAt, _linkPosesAt);
            return _linkPosesAt[link];
        }

        /// <summary>Returns the tool's planned pose in the robot's base frame at a time, however far ahead.</summary>
        /// <returns>False if a joint up to the tool follows no plan at that time.</returns>
        public bool TryPlanTool(ControlTime at, out RigidTransform tool)
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

        PoseState StateAt(in DisplayMoment moment, bool isJointReportedMissing)
        {
            var held = isJointReportedMissing;
            var kinds = _tracks.Kinds;
            foreach (var joint in _toolJoints)
            {
                if (kinds[joint] == PredictionKind.None) return PoseState.Incomplete;
                held |= kinds[joint] == PredictionKind.Held;
            }
            if (!moment.IsTrusted) return PoseState.Unsynchronised;
            if (held) return PoseState.Held;
            return moment.Range == RangeState.Outside ? PoseState.OutsideRange : PoseState.Current;
        }
    }
}
