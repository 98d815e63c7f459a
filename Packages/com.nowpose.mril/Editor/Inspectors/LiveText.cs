using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using UnityEngine;

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

        /// <summary>Formats a position in metres.</summary>
        public static string Place(double x, double y, double z) => "x " + Metres(x) + "   y " + Metres(y) + "   z " + Metres(z);

        /// <summary>Formats a rotation about the vertical axis in degrees, positive to the left.</summary>
        public static string TurnToLeft(Quaternion turn)
        {
            var forward = turn * Vector3.forward;
            return Degrees(Math.Atan2(-forward.x, forward.z));
        }

        public static string Degrees(double radians) => Number(radians * Mathf.Rad2Deg, "0.0", "°");

        /// <summary>Appends the local time of day, or the date if it was another day, since when a value or state has existed.</summary>
        /// <param name="since">Control time; null while unknown. Nothing is appended then.</param>
        /// <param name="session">The session component with the control clock; null for none.</param>
        public static string WithSince(string text, ControlTime? since, MrilSession session)
        {
            var time = new SinceText().Of(session == null ? null : session.Statistics?.Now - since, DateTime.Now);
            return time.Length == 0 ? text : text + ", " + time;
        }

        /// <summary>Formats a number.</summary>
        /// <param name="format">Format string as for <see cref="double.ToString(string)"/>.</param>
        /// <param name="unit">Text after the number, including a space if one is needed.</param>
        public static string Number(double? value, string format, string unit) =>
            value.HasValue ? value.Value.ToString(format, CultureInfo.InvariantCulture) + unit : Unknown;

        static string Metres(double value) => Number(value, "0.000", "");
    }
}
