using System;
using Newtonsoft.Json;

namespace Nowpose.Protocol.Cell
{
    /// <summary>geometry_msgs/TransformStamped: the pose of a child frame in its parent frame at one control time.</summary>
    readonly struct FrameTransform
    {
        /// <summary>Maximum deviation of a received quaternion's norm from 1.</summary>
        public const double NormTolerance = 1e-3;

        // Accepts a norm of exactly 1 ± NormTolerance despite rounding errors.
        const double Rounding = 1e-9;

        /// <param name="stamp">See <see cref="Stamp"/>.</param>
        /// <param name="x">Coordinate in metres, like <paramref name="y"/> and <paramref name="z"/>.</param>
        /// <param name="qx">Component of a unit quaternion, like <paramref name="qy"/>, <paramref name="qz"/> and <paramref name="qw"/>.</param>
        public FrameTransform(
            ControlTime stamp, string parent, string child, double x, double y, double z, double qx, double qy, double qz, double qw)
        {
            Stamp = stamp;
            Parent = parent;
            Child = child;
            X = x;
            Y = y;
            Z = z;
            Qx = qx;
            Qy = qy;
            Qz = qz;
            Qw = qw;
        }

        /// <summary>t_k: time of the pose, on the control clock C1. Zero in a stationary frame, whose pose is valid at all times.</summary>
        public ControlTime Stamp { get; }

        /// <summary>Frame in which the pose is given: <see cref="FrameParents.World"/>, a link of a robot, or another child frame.</summary>
        public string Parent { get; }

        /// <summary>Frame whose pose is given.</summary>
        public string Child { get; }

        /// <summary>Translation along the parent's x axis, metres.</summary>
        public double X { get; }

        /// <summary>Translation along the parent's y axis, metres.</summary>
        public double Y { get; }

        /// <summary>Translation along the parent's z axis, metres.</summary>
        public double Z { get; }

        /// <summary>Component i of the unit quaternion, right-handed.</summary>
        public double Qx { get; }

        /// <summary>Component j of the unit quaternion.</summary>
        public double Qy { get; }

        /// <summary>Component k of the unit quaternion.</summary>
        public double Qz { get; }

        /// <summary>Real component of the unit quaternion.</summary>
        public double Qw { get; }

        /// <summary>Returns the same pose at another time.</summary>
        public FrameTransform At(ControlTime stamp) => new FrameTransform(stamp, Parent, Child, X, Y, Z, Qx, Qy, Qz, Qw);

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Header(Stamp, form, Parent);
            json.Text("child_frame_id", Child);
            json.StartObject("transform");
            json.StartObject("translation");
            json.Number("x", X);
            json.Number("y", Y);
            json.Number("z", Z);
            json.WriteEndObject();
            json.StartObject("rotation");
            json.Number("x", Qx);
            json.Number("y", Qy);
            json.Number("z", Qz);
            json.Number("w", Qw);
            json.WriteEndObject();
            json.WriteEndObject();
            json.WriteEndObject();
        }

        /// <summary>Divides a quaternion by its norm, if the norm is within <see cref="NormTolerance"/> of 1.</summary>
        /// <returns>False if the norm deviates by more; the quaternion is then unchanged.</returns>
        public static bool TryNormalise(ref double qx, ref double qy, ref double qz, ref double qw)
        {
            var norm = Math.Sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
            // The negated comparison also rejects NaN.
            if (!(Math.Abs(norm - 1) <= NormTolerance + Rounding)) return false;
            qx /= norm;
            qy /= norm;
            qz /= norm;
            qw /= norm;
            return true;
        }
    }
}
