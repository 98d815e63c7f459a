using System;

namespace Nowpose.Latency.Profile
{
    /// <summary>Method that determined L_visu. The members are ordered from the most to the least accurate.</summary>
    enum CalibrationMethod
    {
        /// <summary>Pictures that show the codes of both clocks, Schnierle &amp; Röck 2022, Eq. (7).</summary>
        VisibleLight,

        /// <summary>Delay of the ghost behind the robot during a sinusoidal motion, measured with a camera.</summary>
        Sine,

        /// <summary>By eye: a user shifted the ghost until it agreed with the robot, during forward and backward motion.</summary>
        Nudge,

        /// <summary>L_visu was entered by a user.</summary>
        Manual,
    }

    /// <summary>Names of calibration methods in files.</summary>
    static class CalibrationMethodNames
    {
        static readonly string[] Names = { "vlc", "sine", "nudge", "manual" };

        public static string NameOf(CalibrationMethod method) => Names[(int)method];

        /// <param name="name">Name exactly as in files.</param>
        public static bool TryParse(string name, out CalibrationMethod method)
        {
            var index = Array.IndexOf(Names, name);
            method = index < 0 ? CalibrationMethod.Manual : (CalibrationMethod)index;
            return index >= 0;
        }

        /// <summary>All names, separated by commas, for messages.</summary>
        public static string All => string.Join(", ", Names);
    }
}
