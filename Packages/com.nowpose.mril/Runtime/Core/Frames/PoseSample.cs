using Nowpose.Kinematics;
using System;
using Nowpose.Messages;

namespace Nowpose.Frames
{
    /// <summary>One pose of a tracked frame in its parent, with the control system's stamp.</summary>
    readonly struct PoseSample
    {
        /// <param name="time">Stamp t_k, which may be wrong, in seconds of control time since a nearby epoch.</param>
        /// <param name="position">Position in the parent's frame, m; finite.</param>
        /// <param name="rotation">Rotation from the frame to its parent.</param>
        /// <param name="order">Sort key in seconds, which determines the order of samples if <paramref name="time"/> is wrong.</param>
        /// <exception cref="ArgumentException">Time, position or order is not finite, or the rotation is <c>default</c>.</exception>
        public PoseSample(double time, in Vector3D position, in UnitQuaternion rotation, double order)
        {
            if (!double.IsFinite(time) || !double.IsFinite(position.X + position.Y + position.Z) || !double.IsFinite(order))
                throw new ArgumentException(FrameMessages.NotFinite(time, position.X, position.Y, position.Z, order));
            if (!rotation.IsRotation) throw new ArgumentException(FrameMessages.RotationLength, nameof(rotation));
            Time = time;
            Position = position;
            Rotation = rotation;
            Order = order;
        }

        /// <inheritdoc cref="PoseSample(double, in Vector3D, in UnitQuaternion, double)"/>
        public PoseSample(double time, in Vector3D position, in UnitQuaternion rotation) : this(time, position, rotation, time) { }

        /// <summary>Stamp t_k, which may be wrong, in s.</summary>
        public double Time { get; }

        /// <summary>Position in the parent's frame, m.</summary>
        public Vector3D Position { get; }

        /// <summary>Rotation from the frame to its parent; q and −q are the same sample.</summary>
        public UnitQuaternion Rotation { get; }

        /// <summary>Sort key of the samples, s: equal to <see cref="Time"/> unless the stamp is wrong.</summary>
        public double Order { get; }
    }
}
