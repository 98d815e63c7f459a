using System.Collections.Generic;
using UnityEditor;
using UnityEngine.Rendering;

namespace Nowpose.Editor.Setup
{
    /// <summary>Settings of a Unity project that the checks read and change.</summary>
    interface IProjectSettings
    {
        /// <summary>Description of the current background activity, for example that a package is being added; null if there is none.</summary>
        string Activity { get; }

        /// <summary>Reason why the last background activity failed; null if it did not fail.</summary>
        string Trouble { get; }

        /// <summary>The platform whose settings are checked.</summary>
        HeadsetPlatform Platform { get; }

        /// <summary>Version of the Unity editor in Unity's notation.</summary>
        string EditorVersion { get; }

        /// <summary>Name of the active build target; null if it is the build target of <see cref="Platform"/>.</summary>
        string OtherTarget { get; }

        /// <summary>Whether the app starts with the active scene; null if the build list does not contain this scene.</summary>
        bool? StartsWithOpenScene { get; }

        bool UsesIl2Cpp { get; set; }

        /// <summary>Architecture of the UWP player: x86, x64, ARM or ARM64.</summary>
        string Architecture { get; set; }

        /// <summary>Whether the Android player is built for ARM64.</summary>
        bool TargetsArm64 { get; }

        /// <summary>Whether the Android player is built for x86-64.</summary>
        bool TargetsX64 { get; }

        bool UsesNetStandard { get; set; }
        bool FrameTimingStats { get; set; }
        bool RunsInBackground { get; set; }

        /// <summary>Graphics APIs that the player may use, in order of preference; empty if the player is not installed.</summary>
        IReadOnlyList<GraphicsDeviceType> GraphicsApis { get; }

        /// <summary>Whether Unity selects the graphics APIs itself.</summary>
        bool IsGraphicsApiAutomatic { get; }

        /// <summary>Whether Graphics Jobs are on; null while another build target is active.</summary>
        bool? UsesGraphicsJobs { get; }

        /// <summary>0 for the old Input Manager, 1 for the Input System, 2 for both; null if the setting cannot be read.</summary>
        int? InputHandling { get; }

        /// <summary>Whether <see cref="InputHandling"/> was set since Unity was started. It takes effect when Unity is started again.</summary>
        bool IsInputHandlingPending { get; }

        /// <summary>Type name of the render pipeline asset; null for the built-in pipeline.</summary>
        string RenderPipeline { get; }

        /// <summary>Whether the main camera of the open scenes clears to black with alpha 0; null without a main camera.</summary>
        bool? ClearsToTransparentBlack { get; }

        /// <summary>Distance of the main camera's near clip plane in metres; null if the open scenes have no main camera.</summary>
        float? NearClipMetres { get; set; }

        /// <summary>Whether the Android player requests internet access.</summary>
        bool AsksForInternet { get; set; }

        /// <summary>Whether the player uses OpenXR as its XR plug-in; null if the project has no settings for XR plug-ins.</summary>
        bool? UsesOpenXr { get; }

        /// <summary>Returns whether an OpenXR feature is enabled for the player; null if the id is unknown.</summary>
        bool? IsFeatureOn(string featureId);

        /// <summary>Enables an OpenXR feature for the player.</summary>
        /// <returns>False if the id is unknown.</returns>
        bool TurnFeatureOn(string featureId);

        /// <summary>Whether the project has OpenXR settings for the player.</summary>
        bool HasOpenXrSettings { get; }

        /// <summary>
        /// Returns the number to which an enumeration setting of OpenXR is set, given the serialised name of the setting; null if no such setting
        /// exists.
        /// </summary>
        int? OpenXrOption(string field);

        /// <summary>Sets an enumeration setting of OpenXR to a number, given the serialised name of the setting.</summary>
        /// <returns>False if the project has no OpenXR settings.</returns>
        bool ChooseOpenXrOption(string field, int value);

        void UseGraphicsApi(GraphicsDeviceType api);
        void TurnGraphicsJobsOff();

        /// <summary>Sets <see cref="InputHandling"/>.</summary>
        /// <returns>False if the setting cannot be written.</returns>
        bool ChooseInputHandling(int value);

        void ClearToTransparentBlack();

        /// <summary>Switches the active build target to <see cref="Platform"/>.</summary>
        /// <returns>False if the editor is installed without support for the platform.</returns>
        bool SwitchToPlatform();

        bool IsAllowed(PlayerSettings.WSACapability capability);
        void Allow(PlayerSettings.WSACapability capability);

        /// <summary>Returns the installed version of a package; null if it is not installed.</summary>
        string VersionOf(string package);

        /// <summary>Starts adding a package. <see cref="Activity"/> and <see cref="Trouble"/> report the progress.</summary>
        void Add(PackageOrigin package);

        void OpenProjectSettings();
    }
}
