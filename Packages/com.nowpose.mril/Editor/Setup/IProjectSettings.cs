using System.Collections.Generic;
using UnityEditor;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
{
    /// <summary>The settings of a Unity project that the checks read and change.</summary>
    interface IProjectSettings
    {
        /// <summary>Description of the background activity, such as adding a package; null if there is none.</summary>
        string Activity { get; }

        /// <summary>Why the newest background activity failed; null if it did not.</summary>
        string Trouble { get; }

        /// <summary>The headset whose player is checked.</summary>
        HeadsetPlatform Platform { get; }

        /// <summary>The version of this editor, in Unity's notation.</summary>
        string EditorVersion { get; }

        /// <summary>Description of the active build target if it is not that of <see cref="Platform"/>; null if it is.</summary>
        string OtherTarget { get; }

        bool UsesIl2Cpp { get; set; }

        /// <summary>Architecture of the UWP player: x86, x64, ARM or ARM64.</summary>
        string Architecture { get; set; }

        bool UsesNetStandard { get; set; }
        bool FrameTimingStats { get; set; }
        bool RunsInBackground { get; set; }

        /// <summary>The graphics APIs that the player may use, in order of preference; empty if the player is not installed.</summary>
        IReadOnlyList<GraphicsDeviceType> GraphicsApis { get; }

        /// <summary>Whether Unity chooses the graphics APIs.</summary>
        bool IsGraphicsApiAutomatic { get; }

        /// <summary>Whether Graphics Jobs are on; null while another build target is active.</summary>
        bool? UsesGraphicsJobs { get; }

        /// <summary>0 for the old Input Manager, 1 for the Input System, 2 for both; null if the setting cannot be read.</summary>
        int? InputHandling { get; }

        /// <summary>Type name of the render pipeline's asset; null for the built-in pipeline.</summary>
        string RenderPipeline { get; }

        /// <summary>Whether the main camera of the open scenes clears to black with alpha 0; null without a main camera.</summary>
        bool? ClearsToTransparentBlack { get; }

        /// <summary>Near clip plane of the main camera in the open scenes, metres; null without a main camera.</summary>
        float? NearClipMetres { get; set; }

        /// <summary>Whether the Android player requests internet access.</summary>
        bool AsksForInternet { get; set; }

        /// <summary>Whether OpenXR is the player's XR plug-in; null if the project has no settings for XR plug-ins.</summary>
        bool? UsesOpenXr { get; }

        /// <summary>Returns whether an OpenXR feature is enabled for the player; null if that id is unknown.</summary>
        bool? IsFeatureOn(string featureId);

        /// <returns>False if that id is unknown.</returns>
        bool TurnFeatureOn(string featureId);

        /// <summary>Gets an enumeration setting of OpenXR by its serialised name; null if there is none.</summary>
        int? OpenXrOption(string field);

        /// <returns>False without OpenXR settings.</returns>
        bool ChooseOpenXrOption(string field, int value);

        void UseGraphicsApi(GraphicsDeviceType api);
        void TurnGraphicsJobsOff();

        /// <returns>False if the setting cannot be written.</returns>
        bool ChooseInputHandling(int value);

        void ClearToTransparentBlack();

        /// <returns>False if the editor was installed without the platform.</returns>
        bool SwitchToPlatform();

        bool IsAllowed(PlayerSettings.WSACapability capability);
        void Allow(PlayerSettings.WSACapability capability);

        /// <summary>Returns the installed version of a package; null if it is not installed.</summary>
        string VersionOf(string package);

        /// <summary>Starts to add a package.</summary>
        void Add(PackageOrigin package);

        void OpenProjectSettings();
    }
}
