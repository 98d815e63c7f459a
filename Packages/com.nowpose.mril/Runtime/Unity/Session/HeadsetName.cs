using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>The name of this headset at a gateway; it must be unique there.</summary>
    static class HeadsetName
    {
        /// <summary>Maximum length in a gateway's list, in characters.</summary>
        const int MaxLength = 64;

        /// <summary>Returns the chosen name or the device's name in its system settings, cut to 64 characters. Main thread only.</summary>
        /// <param name="chosen">Null or empty for the device's name.</param>
        public static string Of(string chosen)
        {
            var name = (string.IsNullOrEmpty(chosen) ? SystemInfo.deviceName ?? "" : chosen).Trim();
            // Adapts an unsuitable device name silently, because the name is not a setting of this package.
            if (name.Length == 0) return "headset";
            if (name.Length <= MaxLength) return name;
            return name.Substring(0, char.IsHighSurrogate(name[MaxLength - 1]) ? MaxLength - 1 : MaxLength);
        }
    }
}
