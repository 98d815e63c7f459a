using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>Displayed pose of a frame in the world, which continues smoothly when the frame gets another parent.</summary>
    sealed class DisplayedPose
    {
        RigidTransform? _former;
        PoseFade _fade;
        double _shownAt = double.NaN;
        double _speed;

        /// <summary>Displayed pose in the world, right-handed, metres; the identity before the first.</summary>
        public RigidTransform World { get; private set; } = RigidTransform.Identity;

        public bool IsKnown { get; private set; }

        /// <summary>Lets the next pose continue from the displayed one, because the parent changes.</summary>
        public void Continue()
        {
            if (IsKnown) _former = World;
        }

        /// <summary>Shows a pose.</summary>
        /// <param name="time">Display time since the epoch, s; NaN while it is unknown.</param>
        public void Show(double time, in RigidTransform pose)
        {
            if (_former is RigidTransform former) _fade = new PoseFade(time, former, pose, _speed);
            _former = null;
            var shown = _fade.At(time, pose);
            Measure(time, shown);
            World = shown;
            IsKnown = true;
        }

        /// <summary>Discards the times, because they are no longer valid. The displayed pose is kept.</summary>
        public void Reset()
        {
            _former = null;
            _fade = default;
            _shownAt = double.NaN;
            _speed = 0;
        }

        // Measures the speed of the displayed object. During a hand-over, the second evaluation for the same time does not change the measured speed.
        void Measure(double time, in RigidTransform next)
        {
            if (double.IsNaN(time)) return;
            if (IsKnown && time > _shownAt)
                _speed = new Vector3D(next.X - World.X, next.Y - World.Y, next.Z - World.Z).Length / (time - _shownAt);
            _shownAt = time;
        }
    }
}
