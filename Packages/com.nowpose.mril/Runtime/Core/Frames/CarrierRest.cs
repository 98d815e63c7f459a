using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>
    /// Detects that the carrier of an object, the parent that the object's source names, has moved since a gripper released the object. It is then
    /// unknown whether the object stands on the carrier.
    /// </summary>
    /// <remarks>Measures the noise of the carrier's source from the grip on, like <see cref="SourceRest"/>.</remarks>
    sealed class CarrierRest
    {
        readonly SourceRest _rest = new SourceRest();
        RigidTransform? _newest;
        bool _isReleased;

        /// <param name="isReleased">Whether the gripper has already released the object.</param>
        public CarrierRest(bool isReleased)
        {
            _rest.Begin();
            _isReleased = isReleased;
        }

        public bool HasMoved { get; private set; }

        /// <summary>Display time at which the motion was detected; null if it is unknown.</summary>
        public ControlTime? MovedAt { get; private set; }

        /// <summary>Starts measuring the noise. Call it at a grip.</summary>
        public void Begin()
        {
            _rest.Begin();
            _newest = null;
            (_isReleased, HasMoved) = (false, false);
        }

        /// <summary>Starts the comparison with the carrier's pose at the release.</summary>
        public void Release()
        {
            if (_newest.HasValue) _rest.Release(_newest.Value);
            (_isReleased, HasMoved) = (true, false);
        }

        /// <summary>Adds the carrier's newest pose in the world. A repeated pose has no effect.</summary>
        /// <param name="at">Display time; null while it is unknown.</param>
        public void Add(in RigidTransform carrier, ControlTime? at)
        {
            if (_newest.HasValue && AreEqual(carrier, _newest.Value)) return;
            if (!_newest.HasValue && _isReleased) _rest.Release(carrier);
            _newest = carrier;
            _rest.Add(carrier);
            if (!_isReleased || HasMoved || !_rest.IsLeftBy(carrier)) return;
            (HasMoved, MovedAt) = (true, at);
        }

        /// <summary>Discards the time of the motion, because it is no longer valid.</summary>
        public void ForgetTime() => MovedAt = null;

        // Equals would allocate. Two rows of a rotation determine the third.
        static bool AreEqual(in RigidTransform a, in RigidTransform b) =>
            a.X == b.X && a.Y == b.Y && a.Z == b.Z
            && a.R00 == b.R00 && a.R01 == b.R01 && a.R02 == b.R02 && a.R10 == b.R10 && a.R11 == b.R11 && a.R12 == b.R12;
    }
}
