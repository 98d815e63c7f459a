using System;
using System.Collections.Generic;
using Nowpose.Editor;
using Nowpose.Editor.Setup;
using UnityEditor;
using UnityEngine.Rendering;

namespace Nowpose.Tests.Unity.Setup
{
    /// <summary>Project settings whose values a test sets.</summary>
    sealed class FakeProject : IProjectSettings
    {
        public FakeProject(HeadsetPlatform platform = null) => Platform = platform ?? HeadsetPlatform.HoloLens2;

        public Dictionary<string, string> Installed { get; } = new Dictionary<string, string>();
        public bool IsInputHandlingWritable { get; set; } = true;
        public int SettingsOpened { get; private set; }

        public string Activity => null;
        public string Trouble => null;
        public HeadsetPlatform Platform { get; }
        public string EditorVersion { get; set; } = "2022.3.62f1";
        public string OtherTarget => null;
        public bool? StartsWithOpenScene { get; set; }
        public bool UsesIl2Cpp { get; set; }
        public string Architecture { get; set; }
        public bool TargetsArm64 => false;
        public bool TargetsX64 { get; set; }
        public bool UsesNetStandard { get; set; }
        public bool FrameTimingStats { get; set; }
        public bool RunsInBackground { get; set; }
        public IReadOnlyList<GraphicsDeviceType> GraphicsApis { get; set; } = Array.Empty<GraphicsDeviceType>();
        public bool IsGraphicsApiAutomatic { get; set; }
        public bool? UsesGraphicsJobs { get; set; }
        public int? InputHandling { get; set; }
        public bool IsInputHandlingPending { get; set; }
        public string RenderPipeline { get; set; }
        public bool? ClearsToTransparentBlack { get; set; }
        public float? NearClipMetres { get; set; }
        public bool AsksForInternet { get; set; }
        public bool? UsesOpenXr => null;
        public bool HasOpenXrSettings => false;

        public bool? IsFeatureOn(string featureId) => null;
        public bool TurnFeatureOn(string featureId) => false;
        public int? OpenXrOption(string field) => null;
        public bool ChooseOpenXrOption(string field, int value) => false;

        public void UseGraphicsApi(GraphicsDeviceType api)
        {
            IsGraphicsApiAutomatic = false;
            GraphicsApis = new[] { api };
        }

        public void TurnGraphicsJobsOff() => UsesGraphicsJobs = false;

        public bool ChooseInputHandling(int value)
        {
            if (IsInputHandlingWritable) (InputHandling, IsInputHandlingPending) = (value, true);
            return IsInputHandlingWritable;
        }

        public void ClearToTransparentBlack() => ClearsToTransparentBlack = true;
        public bool SwitchToPlatform() => false;
        public bool IsAllowed(PlayerSettings.WSACapability capability) => false;

        public void Allow(PlayerSettings.WSACapability capability)
        {
        }

        public string VersionOf(string package) => Installed.TryGetValue(package, out var version) ? version : null;

        public void Add(PackageOrigin package) => Installed[package.Name] = package.Reference;

        public void OpenProjectSettings() => SettingsOpened++;
    }
}
