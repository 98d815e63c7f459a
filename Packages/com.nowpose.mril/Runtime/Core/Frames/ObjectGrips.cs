using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Frames
{
    /// <summary>
    /// What the grippers of the cell do to one object: the place that they assign to it, and whether they may have moved it unnoticed.
    /// </summary>
    sealed class ObjectGrips
    {
        SourceRest _sourceRest;
        CarrierRest _carrierRest;
        ReachPlace _waiting;
        ReachGrip _unknownGrip, _moverBeforeGrip;
        ReachPlace _recordedRelease;
        ControlTime? _movedAt, _watchedSince;

        /// <summary>Place in the displayed frame; null if the object's own source determines the place.</summary>
        public ReachPlace Shown { get; private set; }

        /// <summary>Place from the next display frame on; null if the object's own source determines the place.</summary>
        public ReachPlace Place => IsWaiting ? _waiting : Shown;

        /// <summary>Whether <see cref="Place"/> is not displayed yet.</summary>
        public bool IsWaiting { get; private set; }

        /// <summary>A gripper that may hold the object, because its held object is unknown; null if there is none.</summary>
        public ReachGrip UnknownGrip => _unknownGrip?.Fault != null ? _unknownGrip : null;

        /// <summary>
        /// A gripper that may have moved the object, and has no fault any more; null if there is none. The place of the object is unknown until its
        /// source reports another pose, or until a gripper grips the object.
        /// </summary>
        public ReachGrip UnknownMover { get; private set; }

        /// <summary>Whether it is unknown whether the object has been moved from its displayed place.</summary>
        public bool IsUnknown => Fault != null;

        /// <summary>Reason why it is unknown whether the object has been moved from its displayed place, in one line; null if it is known.</summary>
        public string Fault =>
            UnknownGrip?.Fault ?? (UnknownMover != null ? FrameMessages.ReleasedUnnoticed : HasCarrierLeft ? FrameMessages.CarrierMoved : null);

        /// <summary>Control time since which there is a <see cref="Fault"/>; null if this time is unknown.</summary>
        public ControlTime? FaultSince => UnknownGrip != null ? UnknownGrip.FaultSince : UnknownMover != null ? _movedAt : _carrierRest?.MovedAt;

        bool HasCarrierLeft => Shown?.IsReleased == true && _carrierRest?.HasMoved == true;

        /// <summary>Whether the poses of the object's source are needed, because the source alone does not determine the place.</summary>
        public bool IsWatched => Place != null || UnknownGrip != null || UnknownMover != null;

        /// <inheritdoc cref="CellFrame.Put"/>
        /// <param name="given">Newest pose of the object's source.</param>
        public void Put(ReachPlace place, in RigidTransform given)
        {
            if (Place == null && place != null) Watch(place.Since);
            var (wasGripped, isGripped) = (Place?.IsReleased == false, place?.IsReleased == false);
            // A withdrawn grip returns the object to a release that has been recorded, unless the message about that release came later. It also
            // restores the mark from before the grip.
            var isNewRelease = place?.IsReleased == true && Place?.IsReleased != true && place != _recordedRelease;
            if (isNewRelease)
            {
                _sourceRest.Release(given);
                _carrierRest?.Release();
            }
            if (isGripped && !wasGripped) _moverBeforeGrip = UnknownMover;
            if (place?.IsReleased != true) UnknownMover = null;
            if (wasGripped && !isGripped && !isNewRelease) UnknownMover = _moverBeforeGrip;
            if (place?.IsReleased == true) _recordedRelease = place;
            (_waiting, IsWaiting) = (place, true);
        }

        /// <summary>Sets whether it is unknown whether a gripper holds the object. Has no effect on another gripper's mark.</summary>
        public void SetUnknownGrip(ReachGrip gripper, bool isUnknown)
        {
            if (!isUnknown && _unknownGrip == gripper) _unknownGrip = null;
            if (!isUnknown) return;
            if (!IsWatched) Watch(since: null);
            _unknownGrip = gripper;
        }

        /// <inheritdoc cref="CellFrame.SetUnknownMover"/>
        /// <param name="given">Newest pose of the object's source.</param>
        public void SetUnknownMover(ReachGrip gripper, ControlTime? since, in RigidTransform given)
        {
            if (!IsWatched) Watch(since: null);
            if (Place == null && !IsAtRest(given)) return;
            (UnknownMover, _movedAt) = (gripper, since);
        }

        /// <inheritdoc cref="CellFrame.Lose"/>
        /// <param name="given">Newest pose of the object's source.</param>
        public void Lose(ReachGrip gripper, ControlTime? since, in RigidTransform given)
        {
            Put(null, given);
            (UnknownMover, _movedAt) = (IsAtRest(given) ? gripper : null, since);
        }

        // If the source has moved the object since the grip, the object was not in the gripper, or its source follows it there.
        bool IsAtRest(in RigidTransform given) => !_sourceRest.ReleaseAtFirst(given);

        /// <inheritdoc cref="CellFrame.WatchFrom"/>
        public void WatchFrom(ControlTime? closing)
        {
            if (Place == null && UnknownGrip != null && UnknownMover == null) Watch(closing);
        }

        void Watch(ControlTime? since)
        {
            _watchedSince = since;
            (_sourceRest ??= new SourceRest()).Begin();
            _carrierRest?.Begin();
        }

        /// <inheritdoc cref="CellFrame.WatchCarrier"/>
        public void WatchCarrier(in RigidTransform carrier, ControlTime? at) =>
            (_carrierRest ??= new CarrierRest(Shown?.IsReleased == true)).Add(carrier, at);

        /// <summary>Adds a newer pose of the object's source. Call it only while <see cref="IsWatched"/>.</summary>
        /// <returns>Whether the source has moved the object after the release.</returns>
        /// <param name="isStationary">Whether the pose has no time and no noise.</param>
        /// <remarks>
        /// A source that has no data about the gripper repeats the pose from before the grip. Therefore, only a different pose shows that the object
        /// was moved.
        /// </remarks>
        public bool IsMovedBy(in RigidTransform source, ControlTime stamp, bool isStationary)
        {
            if (!isStationary && !(stamp <= _watchedSince)) _sourceRest.Add(source);
            var isReleased = Place == null ? UnknownMover != null : Place.IsReleased && (isStationary || stamp > Place.Since);
            return isReleased && (isStationary || _sourceRest.IsNoiseKnown) && _sourceRest.IsLeftBy(source);
        }

        /// <summary>Displays <see cref="Place"/> from now on.</summary>
        public void Show() => (Shown, IsWaiting) = (Place, false);

        /// <summary>Lets the object's own source determine its place at once, because the source has given the object another parent.</summary>
        public void TakeOver()
        {
            (Shown, IsWaiting) = (null, false);
            UnknownMover = null;
        }

        /// <summary>Discards all times, because they are no longer valid.</summary>
        public void ForgetTimes()
        {
            _carrierRest?.ForgetTime();
            Place?.ForgetTime();
            (Shown, IsWaiting) = (Place, false);
            _movedAt = _watchedSince = null;
        }
    }
}
