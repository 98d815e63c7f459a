using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;

namespace Nowpose.Session
{
    /// <summary>Computes a robot's displayed frame: the joints at the display time, the state of the pose, and the link poses.</summary>
    sealed class FrameComputer
    {
        readonly JointTracks _tracks;
        readonly ForwardKinematics _kinematics;
        readonly RigidTransform[] _linkPoses;
        readonly RigidTransform[] _heldLinkPoses;
        readonly int _toolLink;
        readonly int[] _toolJoints;
        readonly int[][] _jointsOfLinks;
        // Kinds of the positions before the joints are held on purpose.
        readonly PredictionKind[] _kinds;
        double[] _positionsAt;
        RigidTransform[] _linkPosesAt;
        bool _isHeldComputed;

        public FrameComputer(RobotModel robot, JointTracks tracks, OutsideRangeResponse outsideRange)
        {
            _tracks = tracks;
            _kinematics = new ForwardKinematics(robot);
            _kinds = new PredictionKind[robot.MovingJoints.Count];
            _linkPoses = new RigidTransform[robot.Links.Count];
            _heldLinkPoses = new RigidTransform[robot.Links.Count];
            _toolLink = robot.IndexOfLink(robot.ToolLink.Name);
            _jointsOfLinks = new int[robot.Links.Count][];
            for (var link = 0; link < _jointsOfLinks.Length; link++) _jointsOfLinks[link] = ToolJoints.OfLink(link, robot);
            _toolJoints = _jointsOfLinks[_toolLink];
            Frame = new DisplayFrame(tracks, _linkPoses, _toolLink, outsideRange);
        }

        /// <summary>The newest frame, which <see cref="Compute"/> overwrites.</summary>
        public DisplayFrame Frame { get; }

        /// <param name="isJointReportedMissing">Whether the gateway reports that a joint of the robot has no data.</param>
        public void Compute(in DisplayMoment moment, bool isJointReportedMissing)
        {
            if (moment.DisplayTime is ControlTime displayTime) _tracks.Predict(displayTime, moment.IsLast);
            else _tracks.Hold();
            _tracks.Kinds.CopyTo(_kinds);
            var state = StateAt(moment, isJointReportedMissing);
            Frame.Set(moment, moment.DisplayTime - _tracks.NewestOf(_toolJoints), state);
            // Holds the joints only after the state is determined, because a pose that is held on purpose must not count as stale.
            if (IsHeldOnPurpose) _tracks.Hold();
            _kinematics.Compute(_tracks.Positions, _linkPoses);
            _isHeldComputed = false;
        }

        /// <summary>
        /// Returns whether the pose of a link is current, apart from the range of the render time, which affects all poses alike: no joint moves the
        /// link, or the robot's pose is current and the joints between base and link are predicted. The link can be on another branch than the tool,
        /// such as a second arm.
        /// </summary>
        public bool IsCurrentAt(int link)
        {
            if (!IsMovedByJoints(link)) return true;
            if (Frame.State != PoseState.Current && Frame.State != PoseState.OutsideRange) return false;
            Tally(_jointsOfLinks[link], out var isIncomplete, out var isHeld);
            return !isIncomplete && !isHeld;
        }

        bool IsHeldOnPurpose => Frame.State == PoseState.OutsideRange && Frame.OutsideRange == OutsideRangeResponse.Hold;

        /// <summary>Returns the link poses for <see cref="DisplayFrame.HeldJoints"/>. Computes them on the first call in a frame.</summary>
        public RigidTransform[] HeldLinkPoses()
        {
            if (!_isHeldComputed) _kinematics.Compute(_tracks.Held, _heldLinkPoses);
            _isHeldComputed = true;
            return _heldLinkPoses;
        }

        /// <summary>Returns the pose of a link in the robot's base frame at any time for which there are samples or a prediction.</summary>
        /// <param name="origin">Origin of the positions of the joints between base and link.</param>
        public RigidTransform LinkPoseAt(int link, ControlTime at, out PoseOrigin origin)
        {
            MakeScratch();
            origin = _tracks.At(at, _jointsOfLinks[link], _positionsAt);
            _kinematics.Compute(_positionsAt, _linkPosesAt);
            return _linkPosesAt[link];
        }

        /// <summary>Gets the planned pose of a link in the robot's base frame at a given time, however far in the future.</summary>
        /// <returns>False if a joint between base and link has no plan for that time, or if no joint moves the link.</returns>
        public bool TryPlan(int link, ControlTime at, out RigidTransform pose)
        {
            MakeScratch();
            var isPlanned = _tracks.TryPlan(at, _jointsOfLinks[link], _positionsAt);
            if (isPlanned) _kinematics.Compute(_positionsAt, _linkPosesAt);
            pose = isPlanned ? _linkPosesAt[link] : RigidTransform.Identity;
            return isPlanned;
        }

        /// <summary>Gets whether a joint moves a link relative to the robot's base.</summary>
        public bool IsMovedByJoints(int link) => _jointsOfLinks[link].Length > 0;

        void MakeScratch()
        {
            _positionsAt ??= new double[_tracks.Positions.Length];
            _linkPosesAt ??= new RigidTransform[_linkPoses.Length];
        }

        PoseState StateAt(in DisplayMoment moment, bool isJointReportedMissing)
        {
            Tally(_toolJoints, out var isIncomplete, out var isHeld);
            return PoseStateRule.Of(moment, isIncomplete, isHeld || isJointReportedMissing);
        }

        // Whether any of the joints has no sample, and whether any is not predicted to the display time.
        void Tally(int[] joints, out bool isIncomplete, out bool isHeld)
        {
            (isIncomplete, isHeld) = (false, false);
            foreach (var joint in joints)
            {
                isIncomplete |= _kinds[joint] == PredictionKind.None;
                isHeld |= _kinds[joint] == PredictionKind.Held;
            }
        }
    }
}
