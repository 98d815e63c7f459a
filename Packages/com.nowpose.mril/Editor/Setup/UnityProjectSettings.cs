using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity.Session;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEditor.PackageManager.Requests;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.SceneManagement;
// This alias is needed because UnityEditor has a type of the same name.
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Nowpose.Editor.Setup
{
    /// <summary>Settings of the project that is open in the editor.</summary>
    sealed class UnityProjectSettings : IProjectSettings
    {
        const string Manifest = "Packages/manifest.json";

        PackageOrigin _package;
        Request _adding;
        string _trouble;

        /// <param name="trouble">Value of <see cref="Trouble"/> before Unity reloaded the scripts; null or empty if there was none.</param>
        public UnityProjectSettings(HeadsetPlatform platform, string trouble = null)
        {
            Platform = platform;
            _trouble = string.IsNullOrEmpty(trouble) ? null : trouble;
        }

        public HeadsetPlatform Platform { get; }

        public string Activity => _adding == null || _adding.IsCompleted ? null : SetupTexts.Adding(_package.Name);

        public string Trouble => _adding != null && _adding.Status == StatusCode.Failure
            ? SetupTexts.PackageNotAdded(_package.Name, _adding.Error.message)
            : _trouble;

        public string EditorVersion => Application.unityVersion;

        public string OtherTarget => EditorUserBuildSettings.activeBuildTarget == Platform.Target
            ? null
            : EditorUserBuildSettings.activeBuildTarget.ToString();

        public bool? StartsWithOpenScene
        {
            get
            {
                var (index, count) = (SceneManager.GetActiveScene().buildIndex, SceneManager.sceneCountInBuildSettings);
                // Without a list, Unity builds the open scene. The index of a scene that is not in the list is -1 or the length of the list.
                if (count == 0 || index == 0) return true;
                return index > 0 && index < count ? false : (bool?)null;
            }
        }

        public bool UsesIl2Cpp
        {
            get => PlayerSettings.GetScriptingBackend(Platform.Named) == ScriptingImplementation.IL2CPP;
            set => PlayerSettings.SetScriptingBackend(Platform.Named, value ? ScriptingImplementation.IL2CPP : ScriptingImplementation.Mono2x);
        }

        public string Architecture
        {
            get => EditorUserBuildSettings.wsaArchitecture;
            set => EditorUserBuildSettings.wsaArchitecture = value;
        }

        public bool TargetsArm64 => Targets(AndroidArchitecture.ARM64);

        public bool TargetsX64 => Targets(AndroidArchitecture.X86_64);

        public bool UsesNetStandard
        {
            get => PlayerSettings.GetApiCompatibilityLevel(Platform.Named) == ApiCompatibilityLevel.NET_Standard;
            set => PlayerSettings.SetApiCompatibilityLevel(
                Platform.Named, value ? ApiCompatibilityLevel.NET_Standard : ApiCompatibilityLevel.NET_Unity_4_8);
        }

        public bool FrameTimingStats
        {
            get => PlayerSettings.enableFrameTimingStats;
            set => PlayerSettings.enableFrameTimingStats = value;
        }

        public bool RunsInBackground
        {
            get => PlayerSettings.runInBackground;
            set => PlayerSettings.runInBackground = value;
        }

        public bool AsksForInternet
        {
            get => PlayerSettings.Android.forceInternetPermission;
            set => PlayerSettings.Android.forceInternetPermission = value;
        }

        public IReadOnlyList<GraphicsDeviceType> GraphicsApis => PlayerSettings.GetGraphicsAPIs(Platform.Target);

        public bool IsGraphicsApiAutomatic => PlayerSettings.GetUseDefaultGraphicsAPIs(Platform.Target);

        public bool? UsesGraphicsJobs => OtherTarget == null ? PlayerSettings.graphicsJobs : (bool?)null;

        public int? InputHandling => ProjectAssets.InputHandling;

        public bool IsInputHandlingPending => ProjectAssets.IsInputHandlingPending;

        public string RenderPipeline =>
            QualitySettings.renderPipeline == null ? ProjectAssets.DefaultRenderPipeline : QualitySettings.renderPipeline.GetType().Name;

        public bool? ClearsToTransparentBlack => MainCamera.ClearsToTransparentBlack;

        public float? NearClipMetres
        {
            get => MainCamera.NearClipMetres;
            set => MainCamera.NearClipMetres = value;
        }

        public bool? UsesOpenXr => XrPlugIns.UseOpenXr(Platform.Group);

        public bool? IsFeatureOn(string featureId) => OpenXrOptions.IsOn(Platform.Group, featureId);

        public bool TurnFeatureOn(string featureId) => OpenXrOptions.TurnOn(Platform.Group, featureId);

        public bool HasOpenXrSettings => OpenXrOptions.Exist(Platform.Group);

        public int? OpenXrOption(string field) => OpenXrOptions.Get(Platform.Group, field);

        public bool ChooseOpenXrOption(string field, int value) => OpenXrOptions.Set(Platform.Group, field, value);

        public void UseGraphicsApi(GraphicsDeviceType api)
        {
            PlayerSettings.SetUseDefaultGraphicsAPIs(Platform.Target, false);
            PlayerSettings.SetGraphicsAPIs(Platform.Target, new[] { api });
        }

        public void TurnGraphicsJobsOff() => PlayerSettings.graphicsJobs = false;

        public bool ChooseInputHandling(int value) => ProjectAssets.ChooseInputHandling(value);

        public void ClearToTransparentBlack() => MainCamera.ClearToTransparentBlack();

        public bool SwitchToPlatform() => EditorUserBuildSettings.SwitchActiveBuildTarget(Platform.Named, Platform.Target);

        public bool IsAllowed(PlayerSettings.WSACapability capability) => PlayerSettings.WSA.GetCapability(capability);

        public void Allow(PlayerSettings.WSACapability capability) => PlayerSettings.WSA.SetCapability(capability, true);

        public string VersionOf(string package) =>
            PackageInfo.GetAllRegisteredPackages().FirstOrDefault(known => known.name == package)?.version;

        public void Add(PackageOrigin package)
        {
            _trouble = null;
            _adding = null;
            _package = package;
            if (package.Identifier != null) _adding = Client.Add(package.Identifier);
            else AddToManifest(package);
        }

        public void OpenProjectSettings() => EditorApplication.ExecuteMenuItem("Edit/Project Settings...");

        static bool Targets(AndroidArchitecture architecture) => (PlayerSettings.Android.targetArchitectures & architecture) != 0;

        // The Package Manager has no API for adding a registry. Client.Resolve makes it read the manifest again.
        void AddToManifest(PackageOrigin package)
        {
            try
            {
                var file = ManifestFile.Read(Manifest);
                // Keeps registries, because a company may have its own copy of a registry.
                var merge = new ManifestMerge(file.Text, Manifest, ConflictRule.Replace, ConflictRule.Refuse);
                merge.Need(package);
                if (merge.Conflicts.Count > 0) throw new InputException(ManifestMessages.Conflicts(string.Join("; ", merge.Conflicts)));
                if (merge.Notes.Count > 0) throw new InputException(string.Join("; ", merge.Notes));
                if (merge.Changes.Count > 0)
                    ConsoleLog.Info(null, SetupTexts.ManifestChanged(Manifest, string.Join("; ", merge.Changes), file.Write(merge.Text)));
                Client.Resolve();
            }
            catch (Exception e) when (e is InputException || e is IOException || e is UnauthorizedAccessException)
            {
                _trouble = SetupTexts.PackageNotAdded(package.Name, e.Message);
            }
        }
    }
}
