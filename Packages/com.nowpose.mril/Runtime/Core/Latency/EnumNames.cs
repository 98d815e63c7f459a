using System;
using Nowpose.Latency.Profile;

namespace Nowpose.Latency
{
    /// <summary>Names of the values of an enum in files, diagnostics and messages.</summary>
    /// <typeparam name="T">An enum with the values 0, 1, 2 and so on.</typeparam>
    sealed class EnumNames<T> where T : struct, Enum
    {
        static readonly T[] Values = (T[])Enum.GetValues(typeof(T));

        readonly Func<T, int> _numberOf;
        readonly string[] _names;

        /// <param name="numberOf">Converts a value to its number without an allocation.</param>
        /// <param name="names">The names in the order of the values.</param>
        public EnumNames(Func<T, int> numberOf, params string[] names) => (_numberOf, _names) = (numberOf, names);

        public string NameOf(T value) => _names[_numberOf(value)];

        /// <param name="name">Name exactly as returned by <see cref="NameOf"/>.</param>
        /// <param name="value">The first value when the method returns false.</param>
        public bool TryParse(string name, out T value)
        {
            var index = Array.IndexOf(_names, name);
            value = Values[Math.Max(0, index)];
            return index >= 0;
        }

        /// <summary>All names except an empty name, separated by commas, for messages.</summary>
        public string All => string.Join(", ", Array.FindAll(_names, name => name.Length > 0));
    }

    /// <summary>The names of the enums of this folder.</summary>
    static class LatencyNames
    {
        public static readonly EnumNames<ReprojectionMode> Reprojection = new EnumNames<ReprojectionMode>(
            mode => (int)mode, "unknown", "none", "orientation_only", "planar_manual", "planar_from_depth", "depth");

        /// <summary>The name of <see cref="RenderTimeSourceKind.None"/> is empty.</summary>
        public static readonly EnumNames<RenderTimeSourceKind> RenderTimeSource = new EnumNames<RenderTimeSourceKind>(
            source => (int)source, "", "display_gpu_time", "engine_gpu_time", "gpu_completion", "camera_cpu");

        public static readonly EnumNames<CalibrationMethod> CalibrationMethod = new EnumNames<CalibrationMethod>(
            method => (int)method, "vlc", "sine", "nudge", "manual");

        public static readonly EnumNames<DepthSubmission> DepthSubmission = new EnumNames<DepthSubmission>(
            depth => (int)depth, "unknown", "active", "turned_off", "not_supported", "no_main_camera", "not_requested");
    }
}
