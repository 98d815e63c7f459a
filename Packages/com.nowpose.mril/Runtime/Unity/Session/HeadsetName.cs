using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Under which name a gateway knows this headset: no two at one gateway may share theirs.</summary>
    static class HeadsetName
    {
        /// <summary>What a gateway lists.</summary>
        const int Greatest = 64;

        /// <summary>The chosen name, or the one that the device has in its system settings; cut to 64 characters. The main thread's.</summary>
        /// <param name="chosen">Null or empty for the device's.</param>
        public static string Of(string chosen)
        {
            var name = (string.IsNullOrEmpty(chosen) ? SystemInfo.deviceName ?? "" : chosen).Trim();
            // What a device calls itself is not ours to complain about.
            if (name.Length == 0) return "headset";
            if (name.Length <= Greatest) return name;
            return name.Substring(0, char.IsHighSurrogate(name[Greatest - 1]) ? Greatest - 1 : Greatest);
        }
    }
}
