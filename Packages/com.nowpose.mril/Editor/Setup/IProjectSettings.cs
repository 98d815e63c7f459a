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

        /// <summary>The headset whose player is looked at.</summary>
        HeadsetPlatform Platform { get; }

        /// <summary>Whether the project is built for it, in words where it is not; null where it is.</summary>
        string OtherTarget { get; }

        bool UsesIl2Cpp { get; set; }

        /// <summary>Of the UWP player: x86, x64, ARM or ARM64.</summary>
        string Architecture { get; set; }

        bool UsesNetStandard { get; set; }
        bool FrameTimingStats { get; set; }
        bool RunsInBackground { get; set; }

        /// <summary>Whether the Android player asks for internet access.</summary>
        bool AsksForInternet { get; set; }

        /// <summary>Whether OpenXR is the player's XR plug-in; null where the project has no settings for XR plug-ins.</summary>
        bool? UsesOpenXr { get; }

        /// <summary>Whether a feature of OpenXR is ticked for the player; null where there is none of that id.</summary>
        bool? IsFeatureOn(string featureId);

        /// <returns>False where there is none of that id.</returns>
        bool TurnFeatureOn(string featureId);

        /// <summary>A choice in the settings of OpenXR, by its serialised name; null where there are none.</summary>
        int? OpenXrOption(string field);

        /// <returns>False where there are no such settings.</returns>
        bool ChooseOpenXrOption(string field, int value);

        /// <returns>False where the editor was installed without the platform.</returns>
        bool SwitchToPlatform();

        bool IsAllowed(PlayerSettings.WSACapability capability);
        void Allow(PlayerSettings.WSACapability capability);

        /// <summary>Null where it is not installed.</summary>
        string VersionOf(string package);

        /// <summary>Begins to add a package.</summary>
        void Add(PackageOrigin package);

        void OpenProjectSettings();
    }
}
