using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Frames
{
    /// <summary>One frame of the cell: a stationary one, or a tracked one with its predictor.</summary>
    sealed class CellFrame
    {
        /// <summary>Maximum number of poses in a new parent that wait for the next display frame; further ones replace the newest.</summary>
        const int MaxWaiting = 8;

        readonly Func<BodyPredictor> _newPredictor;
        readonly FrameTransform[] _waiting = new FrameTransform[MaxWaiting];
        BodyPredictor _predictor;
        RigidTransform _fixed;
        RigidTransform? _shown;
        ControlTime? _newest;
        HandOver _handOver;
        int _waitingCount;
        bool _isNextStationary, _hasPose;

        /// <param name="newPredictor">Creates the predictor for the first pose of a tracked frame; stationary ones need none.</param>
        public CellFrame(string name, Func<BodyPredictor> newPredictor)
        {
            Name = name;
            _newPredictor = newPredictor;
        }

        public string Name { get; }

        /// <summary>Name of the parent in which the displayed pose is given.</summary>
        public string Parent { get; private set; }

        public bool IsStationary { get; private set; }

        /// <summary>Whether poses in another parent wait for the next display frame.</summary>
        public bool IsBeingHandedOver => _waitingCount > 0;

        /// <summary>Displayed pose in the world, right-handed, metres.</summary>
        public RigidTransform World { get; private set; } = RigidTransform.Identity;

        public FrameState State { get; private set; }

        /// <summary>Stamp of the newest pose; null before the first, and for a stationary frame.</summary>
        public ControlTime? Newest => IsStationary ? null : _newest;

        /// <summary>Adds a received pose, whose parent may be another one than before.</summary>
        /// <param name="epoch">Time from which the predictor counts.</param>
        public DropReason Add(in FrameTransform pose, bool isStationary, ControlTime epoch)
        {
            if (Parent == null) Begin(pose, isStationary);
            if (pose.Parent == Parent && isStationary == IsStationary && !IsBeingHandedOver) return Take(pose, epoch);
            if (_waitingCount > 0 && _waiting[0].Parent != pose.Parent) _waitingCount = 0;
            if (_waitingCount == MaxWaiting) _waitingCount--;
            _waiting[_waitingCount++] = pose;
            _isNextStationary = isStationary;
            return DropReason.None;
        }

        /// <summary>
        /// Changes to the parent of the waiting poses. The history starts again with them, and the displayed pose goes on from
        /// <see cref="World"/>, which must be the one that the former parent gives at the next display time.
        /// </summary>
        public void ChangeParent(ControlTime epoch)
        {
            if (_hasPose) _shown = World;
            Begin(_waiting[0], _isNextStationary);
            for (var i = 0; i < _waitingCount; i++) Take(_waiting[i], epoch);
            _waitingCount = 0;
        }

        /// <summary>Computes the displayed pose.</summary>
        /// <param name="time">Display time since the epoch, s; NaN while it is unknown.</param>
        /// <param name="parent">Displayed pose of the parent in the world.</param>
        public void Evaluate(double time, in RigidTransform parent, bool isParentCurrent)
        {
            var kind = PredictionKind.Interpolated;
            var pose = IsStationary ? _fixed : double.IsNaN(time) ? _predictor.Newest(out kind) : _predictor.At(time, out kind);
            State = kind == PredictionKind.None ? FrameState.Missing
                : kind == PredictionKind.Held ? FrameState.Held
                : isParentCurrent ? FrameState.Current : FrameState.ParentNotCurrent;
            if (kind == PredictionKind.None) return;
            var now = parent * pose;
            if (_shown is RigidTransform shown) _handOver = new HandOver(time, shown, now);
            _shown = null;
            World = _handOver.At(time, now);
            _hasPose = true;
        }

        /// <summary>The parent is unknown: keeps the pose that was shown last.</summary>
        public void Orphan() => State = FrameState.Orphan;

        /// <summary>Discards the poses of a tracked frame, because their times are not valid any more. The displayed pose is kept.</summary>
        public void Reset()
        {
            _waitingCount = 0;
            _handOver = default;
            _shown = null;
            if (IsStationary) return;
            _predictor.Reset();
            _newest = null;
        }

        void Begin(in FrameTransform pose, bool isStationary)
        {
            Parent = pose.Parent;
            IsStationary = isStationary;
            if (!isStationary) _predictor ??= _newPredictor();
            _predictor?.Reset();
            _newest = null;
        }

        DropReason Take(in FrameTransform pose, ControlTime epoch)
        {
            if (IsStationary)
            {
                _fixed = pose.ToPose();
                return DropReason.None;
            }
            UnitQuaternion.TryNormalise(pose.Qx, pose.Qy, pose.Qz, pose.Qw, out var rotation);
            var outcome = _predictor.Add(new PoseSample(
                ClockTicks.Seconds(pose.Stamp - epoch), new Vector3D(pose.X, pose.Y, pose.Z), rotation));
            if (!(pose.Stamp <= _newest) || outcome == SampleOutcome.StartedAnew) _newest = pose.Stamp;
            return outcome == SampleOutcome.Duplicate ? DropReason.DuplicateSample
                : outcome == SampleOutcome.TooOld ? DropReason.LateSample : DropReason.None;
        }
    }
}
