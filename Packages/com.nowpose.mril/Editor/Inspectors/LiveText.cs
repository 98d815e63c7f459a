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

        /// <summary>Formats the position of a joint in degrees or millimetres.</summary>
        /// <param name="position">Position of the joint in rad or m.</param>
        public static string Position(RobotJoint joint, double position) => joint.Kind == JointKind.Prismatic
            ? Number(1000 * position, "0.0", " mm")
            : Number(position * (180 / Math.PI), "0.0", "°");

        /// <summary>Formats a number.</summary>
        /// <param name="format">Format string as for <see cref="double.ToString(string)"/>.</param>
        /// <param name="unit">Text after the number, including a space if one is needed.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;
    }
}
