using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>A stationary frame of the cell, or a tracked frame with its predictor.</summary>
    sealed class CellFrame
    {
        /// <summary>Time without new poses after which they have stopped, s.</summary>
        const double MaxSilence = 1;

        readonly Func<BodyPredictor> _newPredictor;
        readonly HandOver _handOver = new HandOver();
        readonly ObjectGrips _grips = new ObjectGrips();
        readonly DisplayedPose _shown = new DisplayedPose();
        BodyPredictor _predictor;
        RigidTransform _given = RigidTransform.Identity;
        ControlTime? _newest;
        string _parent;
        double _displayed = double.NaN;
        // First display time after the arrival of the newest pose, if this pose was already too old to be predicted up to it; otherwise NaN.
        double _oldArrival = double.NaN;
        bool _hasArrived;
        bool _isStationary;

        /// <param name="newPredictor">Creates the predictor for the first pose of a tracked frame. Stationary frames need no predictor.</param>
        public CellFrame(string name, Func<BodyPredictor> newPredictor) => (Name, _newPredictor) = (name, newPredictor);

        public string Name { get; }

        /// <summary>
        /// Name of the parent of the displayed pose. While a gripper determines the place, this is the gripper's link or, after the release, the
        /// world.
        /// </summary>
        public string Parent => _grips.Shown?.Parent ?? _parent;

        /// <summary>Name of the parent in the poses that are received.</summary>
        public string SourceParent => _parent;

        /// <summary>Whether the poses that are received come from /tf_static.</summary>
        public bool HasStationarySource => _isStationary;

        /// <summary>Whether the displayed pose comes from /tf_static.</summary>
        public bool IsStationary => _isStationary && _grips.Shown == null;

        /// <summary>
        /// Whether the pose of a stationary frame is from before the newest connection, so that its source may be gone. The next pose resets it.
        /// </summary>
        public bool IsOutdated { get; set; }

        /// <summary>Whether a user has placed the frame by hand, and no source has published it since. The next pose resets it.</summary>
        public bool IsPlacedByHand { get; set; }

        /// <summary>
        /// Whether the displayed pose is the same at any display time, because this frame and all frames above it are stationary, and no joint moves a
        /// link above it.
        /// </summary>
        public bool IsFixed { get; private set; }

        /// <summary>
        /// Place that a gripper assigns to the object from the next display frame on; null if the object's own source determines the place.
        /// </summary>
        public ReachPlace Reach => _grips.Place;

        /// <summary>Whether a change of the parent, or of the place that a gripper determines, waits for the next display frame.</summary>
        public bool IsBeingHandedOver => _handOver.Count > 0 || _grips.IsWaiting;

        /// <inheritdoc cref="ObjectGrips.UnknownGrip"/>
        public ReachGrip UnknownGrip => _grips.UnknownGrip;

        /// <inheritdoc cref="ObjectGrips.UnknownMover"/>
        public ReachGrip UnknownMover => _grips.UnknownMover;

        /// <summary>Whether a gripper determines the place, although the object's source names a parent that can move.</summary>
        public bool IsAwayFromCarrier => _grips.Shown != null && _parent != FrameParents.World;

        /// <inheritdoc cref="ObjectGrips.Fault"/>
        public string GripFault => _grips.Fault;

        /// <summary>Control time since which the state has been <see cref="FrameState.GripUnknown"/>; null if this time is unknown.</summary>
        public ControlTime? GripFaultSince => _grips.FaultSince;

        /// <inheritdoc cref="DisplayedPose.World"/>
        public RigidTransform World => _shown.World;

        /// <summary>Whether the frame has a pose in the world on which other frames can be placed, current or not.</summary>
        public bool IsPlaced => _shown.IsKnown && State != FrameState.Orphan;

        /// <summary>Newest pose in the parent, which a display without compensation shows; the identity before the first pose.</summary>
        public RigidTransform Held => _grips.Shown?.Pose ?? _given;

        public FrameState State { get; private set; }

        /// <summary>
        /// The parent in the newest received pose if the tree cannot take it, for example because of a cycle; null if that pose was used. The frame is then
        /// held, because it is at another place according to its source.
        /// </summary>
        public string RefusedParent { get; set; }

        /// <summary>Whether new poses of a held frame arrive, but are too old to be predicted until the next one.</summary>
        public bool ReceivesOldPoses => State == FrameState.Held && _displayed - _oldArrival <= MaxSilence;

        /// <summary>Whether new poses of a held frame arrive, but at intervals that are longer than a prediction.</summary>
        public bool ReceivesRarePoses => State == FrameState.Held && _predictor.Interval > _predictor.MaxAhead
            && _displayed - _predictor.NewestTime <= MaxSilence + _predictor.MaxAhead;

        /// <summary>Stamp of the newest pose; null before the first pose, and for a stationary frame.</summary>
        public ControlTime? Newest => _isStationary ? null : _newest;

        /// <summary>Whether no gripper holds the object or may have moved it to an unknown place.</summary>
        public bool IsFree => Reach?.IsReleased != false && UnknownMover == null;

        /// <summary>Returns whether the poses of a tracked frame have stopped.</summary>
        public bool IsSilentAt(ControlTime time, TimeSpan maxAge) => !_isStationary && !(time - _newest <= maxAge);

        /// <inheritdoc cref="HandOver.IsOvertaken"/>
        public bool IsOvertaken(in FrameTransform pose) => _handOver.IsOvertaken(pose, _parent, Newest);

        /// <inheritdoc cref="HandOver.Refuse"/>
        public void Refuse(in FrameTransform pose) => _handOver.Refuse(pose);

        /// <summary>Adds a received pose, whose parent may differ from the previous one.</summary>
        /// <param name="epoch">Time from which the predictor counts.</param>
        public DropReason Add(in FrameTransform pose, bool isStationary, ControlTime epoch)
        {
            IsOutdated = IsPlacedByHand = false;
            RefusedParent = null;
            _handOver.EndRefusals();
            if (_parent == null) Begin(pose, isStationary);
            if (pose.Parent == _parent && isStationary == _isStationary && _handOver.Count == 0)
            {
                if (_grips.IsWatched && !(pose.Stamp <= _newest) && _grips.IsMovedBy(pose.ToPose(), pose.Stamp, _isStationary)) Put(null);
                return Take(pose, epoch);
            }
            _handOver.Add(pose, isStationary);
            return DropReason.None;
        }

        /// <summary>
        /// Sets the place that a gripper assigns to the object from the next display frame on. It is blended like a change of the parent.
        /// </summary>
        /// <param name="place">The place, after a withdrawn grip that of the earlier release; null if the object's own source determines the place again.</param>
        public void Put(ReachPlace place) => _grips.Put(place, _given);

        /// <summary>
        /// If it is unknown whether a gripper holds the object, compares the poses of the object's source from now on with the first one after a
        /// closing. The poses from before the closing do not show whether the object is in the gripper.
        /// </summary>
        /// <param name="closing">Time stamp of the closing; null if it is unknown.</param>
        public void WatchFrom(ControlTime? closing) => _grips.WatchFrom(closing);

        /// <inheritdoc cref="ObjectGrips.SetUnknownGrip"/>
        public void SetUnknownGrip(ReachGrip gripper, bool isUnknown) => _grips.SetUnknownGrip(gripper, isUnknown);

        /// <summary>
        /// Marks the object, because a gripper may have moved it unnoticed. Has no effect if the source has moved the object during the unknown grip:
        /// the object was then not in the gripper, or its source follows it there.
        /// </summary>
        /// <param name="since">Time of the opening; null if unknown.</param>
        public void SetUnknownMover(ReachGrip gripper, ControlTime? since) => _grips.SetUnknownMover(gripper, since, _given);

        /// <summary>
        /// Lets the object's own source determine its place again, and marks the object as <see cref="SetUnknownMover"/> does, because a gripper has
        /// released it at an unknown place.
        /// </summary>
        /// <param name="since">Time of the release; null if unknown.</param>
        public void Lose(ReachGrip gripper, ControlTime? since) => _grips.Lose(gripper, since, _given);

        /// <summary>Takes the pose of <see cref="SourceParent"/> in the world, according to the newest samples. Allocates at the first call.</summary>
        /// <param name="at">Display time; null while it is unknown.</param>
        public void WatchCarrier(in RigidTransform carrier, ControlTime? at) => _grips.WatchCarrier(carrier, at);

        /// <summary>Returns the pose in <see cref="SourceParent"/> at a time other than the displayed one, according to its source.</summary>
        /// <param name="time">Time since the epoch, s.</param>
        public RigidTransform PoseAt(double time, out PoseOrigin origin)
        {
            origin = PoseOrigin.Measured;
            return _isStationary ? _given : _predictor.PoseAt(time, out origin);
        }

        /// <summary>
        /// Changes to the parent of the waiting poses, or to the place that a gripper determines. With another parent, the history starts again
        /// with these poses, and a displayed pose that is current continues from <see cref="World"/>, which must have been computed with the former
        /// parent for the next display time.
        /// </summary>
        public void ChangeParent(ControlTime epoch)
        {
            // A pose that is not current is not where the object was.
            if (State == FrameState.Current) _shown.Continue();
            _grips.Show();
            if (_handOver.Count == 0) return;
            // The object's source has priority: it has given the object another parent.
            _grips.TakeOver();
            Begin(_handOver[0], _handOver.IsStationary);
            for (var i = 0; i < _handOver.Count; i++) Take(_handOver[i], epoch);
            _handOver.End();
        }

        /// <summary>Computes the displayed pose.</summary>
        /// <param name="time">Display time since the epoch, s; NaN while it is unknown.</param>
        /// <param name="parent">Displayed pose of the parent in the world.</param>
        /// <param name="isParentFixed">Whether the parent has the same pose at any display time.</param>
        public void Evaluate(double time, in RigidTransform parent, bool isParentCurrent, bool isParentFixed)
        {
            IsFixed = IsStationary && isParentFixed;
            if (!double.IsNaN(time)) SetDisplayed(time);
            var pose = PoseInParent(time, out var kind);
            State = kind == PredictionKind.None ? FrameState.Missing
                : kind == PredictionKind.Held || (RefusedParent != null && _grips.Shown == null) ? FrameState.Held
                : _grips.IsUnknown ? FrameState.GripUnknown
                : isParentCurrent ? FrameState.Current : FrameState.ParentNotCurrent;
            if (kind != PredictionKind.None) _shown.Show(time, parent * pose);
        }

        void SetDisplayed(double time)
        {
            _displayed = time;
            if (_hasArrived) _oldArrival = IsTooOld(time - _predictor.NewestTime) ? time : double.NaN;
            _hasArrived = false;
        }

        // A pose must be predicted until the next one arrives, unless the interval alone is too long for this.
        bool IsTooOld(double age)
        {
            var (interval, max) = (_predictor.Interval, _predictor.MaxAhead);
            return age + (interval <= max ? interval : 0) > max;
        }

        // A released object is current only while its source sends poses, because only the source reports that the object is moved again.
        RigidTransform PoseInParent(double time, out PredictionKind kind)
        {
            kind = PredictionKind.Interpolated;
            if (_grips.Shown?.IsReleased == false) return Held;
            if (_isStationary && IsOutdated) kind = PredictionKind.Held;
            if (_isStationary) return Held;
            var pose = double.IsNaN(time) ? _predictor.Newest(out kind) : _predictor.At(time, out kind);
            if (_grips.Shown == null) return pose;
            if (kind == PredictionKind.None) kind = PredictionKind.Held;
            return _grips.Shown.Pose;
        }

        /// <summary>Keeps the displayed pose, because the parent or a frame above it is unknown.</summary>
        public void Orphan() => (State, IsFixed) = (FrameState.Orphan, false);

        /// <summary>Discards the poses of a tracked frame, because their times are no longer valid. The displayed pose is kept.</summary>
        public void Reset()
        {
            _handOver.Reset();
            _shown.Reset();
            _grips.ForgetTimes();
            ForgetTimes();
            if (!_isStationary) _predictor.Reset();
        }

        void Begin(in FrameTransform pose, bool isStationary)
        {
            var hasFormerParent = _parent != null;
            _parent = pose.Parent;
            _isStationary = isStationary;
            if (!isStationary) _predictor ??= _newPredictor();
            if (hasFormerParent) _predictor?.ChangeParent();
            else _predictor?.Reset();
            ForgetTimes();
        }

        void ForgetTimes() => (_newest, _displayed, _oldArrival, _hasArrived) = (null, double.NaN, double.NaN, false);

        DropReason Take(in FrameTransform pose, ControlTime epoch)
        {
            if (_isStationary)
            {
                _given = pose.ToPose();
                return DropReason.None;
            }
            UnitQuaternion.TryNormalise(pose.Qx, pose.Qy, pose.Qz, pose.Qw, out var rotation);
            var restarts = _predictor.Restarts;
            var reason = _predictor.Add(new PoseSample(
                ClockTicks.Seconds(pose.Stamp - epoch), new Vector3D(pose.X, pose.Y, pose.Z), rotation), _displayed);
            var hasRestarted = _predictor.Restarts != restarts;
            if (!(pose.Stamp <= _newest) || hasRestarted || _predictor.IsNewestStampWrong)
                (_newest, _given, _hasArrived) = (pose.Stamp, rotation.At(pose.X, pose.Y, pose.Z), true);
            // The time stamp of the release belongs to the earlier run of the source.
            if (hasRestarted && (Reach?.IsReleased == true || UnknownMover != null)) Put(null);
            return reason;
        }
    }
}
