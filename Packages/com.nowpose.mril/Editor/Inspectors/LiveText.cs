using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Status;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Formats values as text, with "–" for unknown values.</summary>
    static class LiveText
    {
        public const string Unknown = NumberTexts.Unknown;

        public static string Ms(TimeSpan? length) => Number(length?.TotalMilliseconds, "0.00", " ms");

        public static string Mm(double? millimetres) => Number(millimetres, "0.00", " mm");

        /// <param name="position">Position of the joint, in rad or m.</param>
        public static string Position(RobotJoint joint, double position) => joint.Kind == JointKind.Prismatic
            ? Number(1000 * position, "0.0", " mm")
            : Number(position * (180 / Math.PI), "0.0", "°");

        /// <param name="format">A format as for <see cref="double.ToString(string)"/>.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;
    }
}
