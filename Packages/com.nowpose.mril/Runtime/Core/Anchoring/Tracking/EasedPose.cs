using System;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Follows a pose that may jump without jumping itself: it nears it by the same part in each span of time.</summary>
    sealed class EasedPose
    {
        /// <summary>Time constants in the time that is given to it: 2 % are left then.</summary>
        const double Constants = 4;

        /// <summary>Less cannot be seen.</summary>
        const double NearMetres = 1e-6, NearRadians = 1e-6;

        /// <summary>A pause is no way that anybody has seen: after it the way begins where it was left.</summary>
        static readonly TimeSpan LongestFrame = TimeSpan.FromMilliseconds(50);

        readonly TimeSpan _ease;
        HeadsetTime? _last;

        public EasedPose(TimeSpan ease) => _ease = ease;

        /// <summary>Null before it followed anything.</summary>
        public RigidTransform? Pose { get; private set; }

        /// <summary>Is there from now on, without a way to it; null to begin anew.</summary>
        public void Jump(in RigidTransform? pose) => Pose = pose;

        public void Follow(in RigidTransform target, HeadsetTime now)
        {
            var passed = _last is HeadsetTime last ? now - last : TimeSpan.Zero;
            _last = now;
            if (!(Pose is RigidTransform pose)) Pose = target;
            else if (pose.DistanceTo(target) < NearMetres && pose.AngleTo(target) < NearRadians) Pose = target;
            else Pose = PoseNumbers.Between(pose, target, PartOf(passed));
        }

        /// <summary>Time passes without anything to follow.</summary>
        public void Rest(HeadsetTime now) => _last = now;

        double PartOf(TimeSpan passed)
        {
            if (_ease <= TimeSpan.Zero) return 1;
            if (passed > LongestFrame) passed = LongestFrame;
            return passed > TimeSpan.Zero ? 1 - Math.Exp(-Constants * passed.Ticks / _ease.Ticks) : 0;
        }
    }
}
