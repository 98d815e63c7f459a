using Nowpose.Editor.Setup;

namespace Nowpose.Editor.Messages
{
    /// <summary>Messages in the set-up window that rate a version of Unity.</summary>
    static class UnityVersionMessages
    {
        public static string TooOld(UnityVersion version, string oldest) =>
            $"{version} is older than {oldest}, the oldest supported version; update Unity";

        public const string Recommended = "use 2022.3 for a HoloLens 2";

        // The members of Unity that the package uses were compared with the public API of these versions.
        const string NotRun = "not run in an editor or on a device";
        public const string Compared2021 = "API compared with 2021.3.26, " + NotRun + "; " + Recommended;
        public const string Compared2022 = "API compared with 2022.3.7, " + NotRun + "; recommended for a HoloLens 2";
        public const string Compared6000 = "API compared with 6000.0.78, " + NotRun + "; " + Recommended;
        public const string NotComparedNewest = "API not compared with this release, " + NotRun;
        public const string NotCompared = NotComparedNewest + "; " + Recommended;

        public const string PlugInFails =
            "Microsoft's Mixed Reality OpenXR 1.11.2 does not compile in Unity 6.3 (6000.3), and its newer versions have not been tested; " + Recommended;
    }
}
