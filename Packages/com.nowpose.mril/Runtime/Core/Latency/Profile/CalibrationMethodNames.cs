using System;

namespace Nowpose.Latency.Profile
{
    /// <summary>Names of calibration methods in files.</summary>
    static class CalibrationMethodNames
    {
        static readonly string[] Names = { "vlc", "sine", "nudge", "manual" };

        public static string NameOf(CalibrationMethod method) => Names[(int)method];

        /// <param name="name">Exactly as written.</param>
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
