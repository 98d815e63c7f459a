using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Smooths the jumps of a pose: the difference between the smoothed pose and the actual pose decays exponentially.</summary>
    sealed class EasedPose
    {
        /// <summary>Number of time constants in the configured duration, after which 2 % of the difference remains.</summary>
        const double TimeConstants = 4;

        /// <summary>Differences below these values are not visible.</summary>
        const double NearMetres = 1e-6, NearRadians = 1e-6;

        /// <summary>Maximum time step. After a pause, the motion continues from where it was interrupted.</summary>
        static readonly TimeSpan MaxFrameTime = TimeSpan.FromMilliseconds(50);

        readonly TimeSpan _ease;
        HeadsetTime? _last;

        public EasedPose(TimeSpan ease) => _ease = ease;

        /// <summary>The smoothed pose; null before the first pose.</summary>
        public RigidTransform? Pose { get; private set; }

        /// <summary>Sets the pose without smoothing. After null, the next pose is applied without smoothing.</summary>
        public void Jump(in RigidTransform? pose) => Pose = pose;

        public void Follow(in RigidTransform target, HeadsetTime now)
        {
            var passed = _last is HeadsetTime last ? now - last : TimeSpan.Zero;
            _last = now;
            if (!(Pose is RigidTransform pose)) Pose = target;
            else if (pose.DistanceTo(target) < NearMetres && pose.AngleTo(target) < NearRadians) Pose = target;
            else Pose = PoseNumbers.Between(pose, target, PartOf(passed));
        }

        /// <summary>Advances the time while no pose is available to follow.</summary>
        public void Rest(HeadsetTime now) => _last = now;

        double PartOf(TimeSpan passed)
        {
            if (_ease <= TimeSpan.Zero) return 1;
            if (passed > MaxFrameTime) passed = MaxFrameTime;
            return passed > TimeSpan.Zero ? 1 - Math.Exp(-TimeConstants * passed.Ticks / _ease.Ticks) : 0;
        }
    }
}
