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
    /// which does not grow with time, because rotations are always relative to a sample near them. Allocates nothing after construction.
    /// </remarks>
    sealed class RotationHistory
    {
        /// <summary>Maximum number of samples: more than the longest history of a forecaster.</summary>
        const int Capacity = 128;

        /// <summary>Rotations below this, in rad, are rounding errors.</summary>
        const double Rounding = 1e-14;

        readonly Entry[] _newestFirst = new Entry[Capacity];

        public int Count { get; private set; }

        /// <summary>Rotation of the newest sample; the identity before the first.</summary>
        public UnitQuaternion Newest => Count > 0 ? _newestFirst[0].Rotation : UnitQuaternion.Identity;

        /// <summary>Adds a sample. Samples may be added in any order.</summary>
        /// <param name="order">Sort key, s.</param>
        /// <returns>Angles of the sample, rad.</returns>
        public Vector3D Add(double order, in UnitQuaternion rotation)
        {
            var age = 0;
            while (age < Count && _newestFirst[age].Order > order) age++;
            if (IsAsOld(age - 1, order)) age--;
            if (IsAsOld(age, order)) return AnglesRelativeTo(_newestFirst[age], rotation);
            // Computes the angles relative to the newer neighbour, so that the angles between the newest samples are exact, even after a late one.
            var angles = Count == 0 ? default : AnglesRelativeTo(_newestFirst[Math.Max(age - 1, 0)], rotation);
            if (age < Capacity) Insert(age, new Entry(order, rotation, angles));
            return angles;
        }

        /// <summary>Returns the rotation for angles at a time.</summary>
        public UnitQuaternion RotationOf(in Vector3D angles, double time)
        {
            var age = 0;
            while (age + 1 < Count && _newestFirst[age].Order > time) age++;
            ref readonly var near = ref _newestFirst[age];
            return UnitQuaternion.Exp(angles - near.Angles) * near.Rotation;
        }

        /// <summary>Discards all rotations.</summary>
        public void Clear() => Count = 0;

        bool IsAsOld(int age, double order) => age >= 0 && age < Count && JointSample.IsSameTime(_newestFirst[age].Order, order);

        // A repeated sample gets exactly the angles of the first one.
        static Vector3D AnglesRelativeTo(in Entry entry, in UnitQuaternion rotation)
        {
            var turn = (rotation * entry.Rotation.Inverse).Log();
            return turn.Length < Rounding ? entry.Angles : entry.Angles + turn;
        }

        void Insert(int age, in Entry entry)
        {
            if (Count < Capacity) Count++;
            Array.Copy(_newestFirst, age, _newestFirst, age + 1, Count - 1 - age);
            _newestFirst[age] = entry;
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
