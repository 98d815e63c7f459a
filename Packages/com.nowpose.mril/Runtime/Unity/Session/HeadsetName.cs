using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Determines the name of this headset, which must be unique at a gateway.</summary>
    static class HeadsetName
    {
        /// <summary>Maximum length in characters in the gateway's list of headsets.</summary>
        const int MaxLength = 64;

        /// <summary>
        /// Returns the chosen name, or the device's name in its system settings, truncated to 64 characters. Call it on the main thread only.
        /// </summary>
        /// <param name="chosen">The chosen name; null or empty selects the device's name.</param>
        public static string Of(string chosen)
        {
            var name = (string.IsNullOrEmpty(chosen) ? SystemInfo.deviceName ?? "" : chosen).Trim();
            // An unsuitable name is not reported as an error, because the name of the device is not a setting of this package.
            if (name.Length == 0) return "headset";
            if (name.Length <= MaxLength) return name;
            return name.Substring(0, char.IsHighSurrogate(name[MaxLength - 1]) ? MaxLength - 1 : MaxLength);
        }
    }
}
