using UnityEditor;

namespace Nowpose.Editor
{
    /// <summary>What the checks see of a Unity project, and may change in it.</summary>
    interface IProjectSettings
    {
        /// <summary>What is being done in the background, such as adding a package; null while nothing is.</summary>
        string Activity { get; }

        /// <summary>Why the newest of it failed; null where it did not.</summary>
        string Trouble { get; }

        BuildTarget BuildTarget { get; }

        bool UsesIl2Cpp { get; set; }

        /// <summary>Of the UWP player: x86, x64, ARM or ARM64.</summary>
        string Architecture { get; set; }

        bool UsesNetStandard { get; set; }
        bool FrameTimingStats { get; set; }
        bool RunsInBackground { get; set; }

        /// <summary>Whether OpenXR is the UWP player's XR plug-in; null where the project has no settings for XR plug-ins.</summary>
        bool? UsesOpenXr { get; }

        /// <returns>False where the editor was installed without that platform.</returns>
        bool SwitchTo(BuildTarget target);

        bool IsAllowed(PlayerSettings.WSACapability capability);
        void Allow(PlayerSettings.WSACapability capability);

        /// <summary>Null where it is not installed.</summary>
        string VersionOf(string package);

        /// <summary>Begins to add a package.</summary>
        void Add(PackageOrigin package);

        void OpenProjectSettings();
    }
}
