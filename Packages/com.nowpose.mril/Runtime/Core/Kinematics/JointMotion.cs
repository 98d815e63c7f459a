using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Kinematics
{
    /// <summary>A link's pose in its parent's frame as a function of its joint's position, with precomputed constants.</summary>
    /// <remarks>
    /// Rodrigues' formula sorted by the terms in q: R0·R(a, q) = R0·aaᵀ + R0·[a]× · sin q + R0·(1 − aaᵀ) · cos q.
    /// A prismatic joint adds R0·a · q to the translation.
    /// </remarks>
    readonly struct JointMotion
    {
        public readonly JointKind Kind;

        /// <summary>Index of the parent link.</summary>
        public readonly int Parent;

        /// <summary>Index of the joint in the array of positions; -1 for a fixed joint.</summary>
        public readonly int Position;
        public readonly RigidTransform Origin;

        // Terms of the rotation. The translation of _sine is R0·a, the sliding direction of a prismatic joint; the other two terms have no
        // translation.
        readonly RigidTransform _constant, _sine, _cosine;

        public JointMotion(RobotLink link)
        {
            var joint = link.ParentJoint;
            var (x, y, z) = joint.Axis;
            Kind = joint.Kind;
            Parent = link.ParentIndex;
            Position = joint.MovingIndex;
            Origin = joint.Origin;
            var o = Origin;
            var turn = new RigidTransform(o.R00, o.R01, o.R02, o.R10, o.R11, o.R12, o.R20, o.R21, o.R22, 0, 0, 0);
            _constant = turn * new RigidTransform(x * x, x * y, x * z, y * x, y * y, y * z, z * x, z * y, z * z, 0, 0, 0);
            _sine = turn * new RigidTransform(0, -z, y, z, 0, -x, -y, x, 0, x, y, z);
            _cosine = turn * new RigidTransform(
                1 - x * x, -x * y, -x * z, -y * x, 1 - y * y, -y * z, -z * x, -z * y, 1 - z * z, 0, 0, 0);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RigidTransform TurnedBy(double radians)
        {
            double s = Math.Sin(radians), c = Math.Cos(radians);
            return new RigidTransform(
                _constant.R00 + _sine.R00 * s + _cosine.R00 * c,
                _constant.R01 + _sine.R01 * s + _cosine.R01 * c,
                _constant.R02 + _sine.R02 * s + _cosine.R02 * c,
                _constant.R10 + _sine.R10 * s + _cosine.R10 * c,
                _constant.R11 + _sine.R11 * s + _cosine.R11 * c,
                _constant.R12 + _sine.R12 * s + _cosine.R12 * c,
                _constant.R20 + _sine.R20 * s + _cosine.R20 * c,
                _constant.R21 + _sine.R21 * s + _cosine.R21 * c,
                _constant.R22 + _sine.R22 * s + _cosine.R22 * c,
                Origin.X, Origin.Y, Origin.Z);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public RigidTransform SlidBy(double metres) => new RigidTransform(
            Origin.R00, Origin.R01, Origin.R02, Origin.R10, Origin.R11, Origin.R12, Origin.R20, Origin.R21, Origin.R22,
            Origin.X + _sine.X * metres, Origin.Y + _sine.Y * metres, Origin.Z + _sine.Z * metres);
    }
}
