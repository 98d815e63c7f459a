using System.Globalization;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Determines the name of this headset, which must be unique at a gateway.</summary>
    static class HeadsetName
    {
        /// <summary>Maximum length in characters in the gateway's list of headsets.</summary>
        const int MaxLength = 64;

        /// <summary>Name of a device that Unity reports if Android has none.</summary>
        const string Unknown = "<unknown>";

        /// <summary>
        /// Returns the chosen name, or the device's name in its system settings, truncated to 64 characters. Call it on the main thread only.
        /// </summary>
        /// <param name="chosen">The chosen name; null or empty selects the device's name.</param>
        /// <remarks>
        /// On Android, the name of the device is usually the name of its model, so four digits distinguish headsets of the same model. They stay the
        /// same on one device.
        /// </remarks>
        public static string Of(string chosen)
        {
            if (string.IsNullOrEmpty(chosen)) return OfDevice();
            var name = chosen.Trim();
            return name.Length == 0 ? "headset" : Truncate(name, MaxLength);
        }

        // An unsuitable name is not reported as an error, because the name of the device is not a setting of this package.
        static string OfDevice()
        {
            var name = (SystemInfo.deviceName ?? "").Trim();
            var isKnown = name.Length > 0 && name != Unknown && name != SystemInfo.unsupportedIdentifier;
            if (isKnown && Application.platform != RuntimePlatform.Android) return Truncate(name, MaxLength);
            var digits = " " + DigitsOf(SystemInfo.deviceUniqueIdentifier);
            return Truncate(isKnown ? name : SystemInfo.deviceModel, MaxLength - digits.Length) + digits;
        }

        static string Truncate(string name, int length)
        {
            if (name.Length <= length) return name;
            return name.Substring(0, char.IsHighSurrogate(name[length - 1]) ? length - 1 : length);
        }

        /// <summary>Returns 16 bits of a hash (FNV-1a) as four hexadecimal digits.</summary>
        static string DigitsOf(string identifier)
        {
            var hash = 2166136261u;
            foreach (var character in identifier) hash = unchecked((hash ^ character) * 16777619);
            return ((hash >> 16) ^ (hash & 0xffff)).ToString("X4", CultureInfo.InvariantCulture);
        }
    }
}
