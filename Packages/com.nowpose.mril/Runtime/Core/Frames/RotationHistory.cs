using Nowpose.Kinematics;
using System;
using Nowpose.Prediction;

namespace Nowpose.Frames
{
    /// <summary>
    /// Keeps the newest rotations of a frame and their angles: the sums of the rotation vectors from sample to sample, about the parent's axes.
    /// </summary>
    /// <remarks>
    /// The angles α are three coordinates without a bound and without a singularity, in which a constant angular velocity is a line:
    /// α_k = α_k−1 + log(q_k q_k−1⁻¹). Near any sample k, q(t) = exp(α(t) − α_k) q_k: this is the tangent space of that sample. The sum is
    /// exact for a fixed axis; otherwise two neighbouring samples that turn about different axes contribute an error of second order,
    /// which does not grow with time, because rotations are always relative to a sample near them.
    /// </remarks>
    sealed class RotationHistory
    {
        /// <summary>Maximum number of samples: more than the longest history of a forecaster. The number is a power of two, for a mask.</summary>
        const int Capacity = 128;

        /// <summary>Rotations by a smaller angle, in rad, are rounding errors.</summary>
        const double Rounding = 1e-14;

        /// <summary>
        /// Maximum angle to the sample before the newest, relative to the angle to the newest, at which the newest is an outlier. A steady motion
        /// has a smaller quotient only if it turns by more than 160° from sample to sample.
        /// </summary>
        const double MaxReturn = 0.25;

        // A ring: the entry of an age is at (_newest + age) & (Capacity - 1).
        readonly Entry[] _ring = new Entry[Capacity];
        int _newest;

        public int Count { get; private set; }

        /// <summary>Rotation of the newest sample; the identity before the first sample.</summary>
        public UnitQuaternion Newest => Count > 0 ? At(0).Rotation : UnitQuaternion.Identity;

        /// <summary>Adds a sample. Samples may be added in any order.</summary>
        /// <param name="order">Sort key, s.</param>
        /// <returns>Angles of the sample, rad.</returns>
        public Vector3D Add(double order, in UnitQuaternion rotation)
        {
            var age = 0;
            while (age < Count && At(age).Order > order) age++;
            if (IsAsOld(age - 1, order)) age--;
            if (IsAsOld(age, order)) return AnglesRelativeTo(At(age), rotation);
            // Computes the angles relative to the newer neighbour, so the angles between the newest samples are exact, even after a late sample.
            var angles = Count == 0 ? default : AnglesRelativeTo(At(age > 0 ? age - 1 : IsReturn(rotation) ? 1 : 0), rotation);
            if (age < Capacity) Insert(age, new Entry(order, rotation, angles));
            return angles;
        }

        /// <summary>Removes the sample with a given order, in s, because its stamp is wrong.</summary>
        public void Remove(double order)
        {
            var age = 0;
            while (age < Count && !IsAsOld(age, order)) age++;
            if (age == Count) return;
            for (; age > 0; age--) At(age) = At(age - 1);
            _newest = (_newest + 1) & (Capacity - 1);
            Count--;
        }

        /// <summary>Converts the angles at a given time to a rotation.</summary>
        public UnitQuaternion RotationOf(in Vector3D angles, double time)
        {
            var age = 0;
            while (age + 1 < Count && At(age).Order > time) age++;
            ref readonly var near = ref At(age);
            return UnitQuaternion.Exp(angles - near.Angles) * near.Rotation;
        }

        /// <summary>Discards all rotations.</summary>
        public void Clear() => Count = 0;

        // A tracker may confuse two rotations once. Relative to the wrong one, the angles would have an error of the size of the motion.
        bool IsReturn(in UnitQuaternion rotation) =>
            Count > 1 && Turn(At(1), rotation).Length < MaxReturn * Turn(At(0), rotation).Length;

        bool IsAsOld(int age, double order) => age >= 0 && age < Count && JointSample.IsSameTime(At(age).Order, order);

        ref Entry At(int age) => ref _ring[(_newest + age) & (Capacity - 1)];

        // A repeated sample has exactly the same angles as the first sample.
        static Vector3D AnglesRelativeTo(in Entry entry, in UnitQuaternion rotation)
        {
            var turn = Turn(entry, rotation);
            return turn.Length < Rounding ? entry.Angles : entry.Angles + turn;
        }

        static Vector3D Turn(in Entry from, in UnitQuaternion to) => (to * from.Rotation.Inverse).Log();

        void Insert(int age, in Entry entry)
        {
            if (Count < Capacity) Count++;
            _newest = (_newest - 1) & (Capacity - 1);
            for (var i = 0; i < age; i++) At(i) = At(i + 1);
            At(age) = entry;
        }

        readonly struct Entry
        {
            public Entry(double order, in UnitQuaternion rotation, in Vector3D angles)
            {
                Order = order;
                Rotation = rotation;
                Angles = angles;
            }

            public readonly double Order;
            public readonly UnitQuaternion Rotation;
            public readonly Vector3D Angles;
        }
    }
}
