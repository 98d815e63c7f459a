using System.Collections.Generic;
using UnityEditor;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
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

        /// <summary>The version of this editor, as Unity writes it.</summary>
        string EditorVersion { get; }

        /// <summary>Whether the project is built for it, in words where it is not; null where it is.</summary>
        string OtherTarget { get; }

        bool UsesIl2Cpp { get; set; }

        /// <summary>Of the UWP player: x86, x64, ARM or ARM64.</summary>
        string Architecture { get; set; }

        bool UsesNetStandard { get; set; }
        bool FrameTimingStats { get; set; }
        bool RunsInBackground { get; set; }

        /// <summary>The graphics APIs that the player may use, the preferred one first; empty where the editor does not know the player.</summary>
        IReadOnlyList<GraphicsDeviceType> GraphicsApis { get; }

        /// <summary>Whether Unity chooses them.</summary>
        bool IsGraphicsApiAutomatic { get; }

        /// <summary>Null while another build target is active.</summary>
        bool? UsesGraphicsJobs { get; }

        /// <summary>0 for the old Input Manager, 1 for the Input System, 2 for both; null where the setting cannot be read.</summary>
        int? InputHandling { get; }

        /// <summary>Type name of the render pipeline's asset; null for the built-in pipeline.</summary>
        string RenderPipeline { get; }

        /// <summary>Whether the main camera of the open scenes clears to black with alpha 0; null without a main camera.</summary>
        bool? ClearsToTransparentBlack { get; }

        /// <summary>Near clip plane of the main camera in the open scenes, metres; null without a main camera.</summary>
        float? NearClipMetres { get; set; }

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

        void UseGraphicsApi(GraphicsDeviceType api);
        void TurnGraphicsJobsOff();

        /// <returns>False where the setting cannot be written.</returns>
        bool ChooseInputHandling(int value);

        void ClearToTransparentBlack();

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
