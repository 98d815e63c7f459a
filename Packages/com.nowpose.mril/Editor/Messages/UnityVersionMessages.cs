using Nowpose.Editor.Setup;

namespace Nowpose.Editor.Messages
{
    /// <summary>Messages in the set-up window that rate a version of Unity.</summary>
    static class UnityVersionMessages
    {
        public static string TooOld(UnityVersion version, string oldest) =>
            $"{version} is older than {oldest}, the oldest version that the package compiles with; update Unity";

        public const string Recommended = "use 2022.3 for a HoloLens 2";
        public const string Compiled2021 = "compiled against 2021.3.26; " + Recommended;
        public const string Compiled2022 = "compiled against 2022.3.7; recommended for a HoloLens 2";
        public const string Compiled6000 = "compiled against 6000.0.78, not tested on a device; " + Recommended;
        public const string NotCompiled = "not compiled against this release; " + Recommended;
        public const string NotTested = "not compiled against this release, not tested on a device; " + Recommended;
        public const string NotTestedOnDevice = "not compiled against this release, not tested on a device";

        public const string PlugInFails =
            "Microsoft's Mixed Reality OpenXR 1.11.2 does not compile in Unity 6.3 (6000.3), and its newer versions have not been tested; " + Recommended;
    }
}
