using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Status;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Values in words, "–" for what is not known.</summary>
    static class LiveText
    {
        public const string Unknown = NumberTexts.Unknown;

        public static string Ms(TimeSpan? length) => Number(length?.TotalMilliseconds, "0.00", " ms");

        public static string Mm(double? millimetres) => Number(millimetres, "0.00", " mm");

        /// <param name="position">Of the joint, rad or m.</param>
        public static string Position(RobotJoint joint, double position) => joint.Kind == JointKind.Prismatic
            ? Number(1000 * position, "0.0", " mm")
            : Number(position * (180 / Math.PI), "0.0", "°");

        /// <param name="format">As for <see cref="double.ToString(string)"/>.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;
    }
}
