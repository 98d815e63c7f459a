using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEngine;
using UnityEngine.Rendering;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>The project checks on the settings of the editor's stand-in.</summary>
public sealed class ProjectChecksTests : EditorFixture
{
    UnityProjectSettings _project;
    ProjectReview _review;
    Camera _camera;

    static IEnumerable<string> SettingChecks => ProjectChecks.ForHoloLens()
        .Where(c => c.FixLabel != null && c is not (PackageCheck or OpenXrLoaderCheck or GraphicsJobsCheck)).Select(c => c.Title);

    [SetUp]
    public void SetUp()
    {
        OpenXrAssets.Put(Keep, BuildTargetGroup.WSA, BuildTargetGroup.Android);
        var player = Keep(ScriptableObject.CreateInstance<PlayerAssetOfATest>());
        player.activeInputHandler = 0;
        Project.Put("ProjectSettings/ProjectSettings.asset", player);
        _camera = Keep(new GameObject("Camera") { tag = "MainCamera" }).AddComponent<Camera>();
        _camera.nearClipPlane = 0.02f;
        _project = new UnityProjectSettings(HeadsetPlatform.HoloLens2);
        _review = new ProjectReview(ProjectChecks.ForHoloLens(), _project);
    }

    [TestCaseSource(nameof(SettingChecks))]
    public void Check_OfASetting_FailsBeforeAndPassesAfterItsFix(string title)
    {
        var check = IndexOf(title);
        Assert.That(_review.Results[check].State, Is.Not.EqualTo(CheckState.Good), "before");

        _review.Fix(check);

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good), _review.Results[check].Found);
        Assert.That(_review.Advice[check], Is.Null);
    }

    [TestCaseSource(nameof(SettingChecks))]
    public void Fix_OfOneSetting_DoesNotChangeOthers(string title)
    {
        var before = _review.Results.ToArray();

        _review.Fix(IndexOf(title));

        var changed = Enumerable.Range(0, before.Length).Where(i => before[i].State != _review.Results[i].State);
        // Unity reports Graphics Jobs only for the active build target.
        Assert.That(changed.Where(i => _review.Checks[i] is not GraphicsJobsCheck), Is.EqualTo(new[] { IndexOf(title) }));
    }

    [Test]
    public void Look_AllChecks_ChangeNothing()
    {
        for (var i = 0; i < 3; i++) _review.Refresh();

        Assert.That(_review.MissingCount, Is.EqualTo(18));
        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.StandaloneWindows64));
        Assert.That(EditorUserBuildSettings.wsaArchitecture, Is.EqualTo("x64"));
        Assert.That(PlayerSettings.runInBackground | PlayerSettings.enableFrameTimingStats, Is.False);
        Assert.That(PlayerSettings.GetUseDefaultGraphicsAPIs(BuildTarget.WSAPlayer) & PlayerSettings.graphicsJobs);
        Assert.That(_camera.nearClipPlane, Is.EqualTo(0.02f));
        Assert.That(Undo.Steps, Is.Empty);
        Assert.That(Client.Asked, Is.Empty);
        Assert.That(EditorApplication.MenuItems, Is.Empty);
    }

    [Test]
    public void Checks_ForHoloLens_NameTheRequiredCapabilities()
    {
        var capabilities = ProjectChecks.ForHoloLens().OfType<CapabilityCheck>().Select(c => c.Title);

        Assert.That(capabilities, Is.EqualTo(new[]
        {
            "Capability InternetClient", "Capability PrivateNetworkClientServer", "Capability WebCam", "Capability SpatialPerception",
            "Capability GazeInput", "Capability Microphone",
        }));
    }

    [Test]
    public void BuildTarget_EditorWithoutUwp_NamesTheRemedy()
    {
        EditorUserBuildSettings.HasUwp = false;
        var check = IndexOf("Build target is Universal Windows Platform");

        _review.Fix(check);

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Missing));
        Assert.That(_review.Advice[check], Does.Contain("Universal Windows Platform Build Support"));
    }

    [Test]
    public void Package_OfUnity_IsRequestedByNameAndFoundOnceInstalled()
    {
        var check = IndexOf("OpenXR");
        Assert.That(_review.Results[check].Found, Is.EqualTo("com.unity.xr.openxr is not installed"));

        _review.Fix(check);
        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.openxr" }));
        Assert.That(_project.Activity, Is.EqualTo("adding com.unity.xr.openxr …"));

        Client.Newest.Succeed();
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.openxr", "1.13.0"));
        _review.Refresh();

        Assert.That(_project.Activity, Is.Null);
        Assert.That(_review.Results[check].Found, Is.EqualTo("com.unity.xr.openxr 1.13.0"));
        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void Package_WithVersion_IsRequestedWithTheVersion()
    {
        _review.Fix(IndexOf("AR Foundation"));

        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.arfoundation@5.1.5" }));
        Assert.That(_project.Activity, Is.EqualTo("adding com.unity.xr.arfoundation …"));
    }

    [Test]
    public void Package_TooOld_IsRecommendedAgain()
    {
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.arfoundation", "4.1.7"));
        PackageInfo.Registered.Add(new PackageInfo("com.microsoft.mixedreality.openxr", "1.11.1-preview"));
        _review.Refresh();

        var found = _review.Results[IndexOf("AR Foundation")];
        Assert.That(found.State, Is.EqualTo(CheckState.Advice));
        Assert.That(found.Found, Is.EqualTo("com.unity.xr.arfoundation 4.1.7 is too old; allowed is 5.0.0 or newer, but older than 7.0.0"));
        Assert.That(_review.Results[IndexOf("Mixed Reality OpenXR")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void Package_CannotBeAdded_StatesTheReason()
    {
        _review.Fix(IndexOf("NativeWebSocket (optional)"));
        Client.Newest.Fail("no git");

        Assert.That(_project.Trouble, Is.EqualTo("com.endel.nativewebsocket could not be added: no git"));
        Assert.That(_project.Activity, Is.Null);
    }

    [Test]
    public void Package_OfMicrosoft_IsAddedToTheManifestWithItsRegistry()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{ \"dependencies\": {} }");
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("\"com.microsoft.mixedreality.openxr\": \"1.11.2\""));
        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("pkgs.dev.azure.com"));
        Assert.That(Client.Resolved, Is.EqualTo(1));
        Assert.That(_project.Trouble, Is.Null);
    }

    [TestCase(null, "com.microsoft.mixedreality.openxr could not be added: Could not find file")]
    [TestCase("nothing", "com.microsoft.mixedreality.openxr could not be added: Packages/manifest.json:1: not a JSON object")]
    public void Package_ManifestInvalid_StatesTheReasonAndChangesNothing(string manifest, string trouble)
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/other.txt", "");
        if (manifest != null) folder.Write("Packages/manifest.json", manifest);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(_project.Trouble, Does.StartWith(trouble));
        Assert.That(Client.Resolved, Is.Zero);
        if (manifest != null) Assert.That(folder.Read("Packages/manifest.json"), Is.EqualTo(manifest));
    }

    [Test]
    public void Checks_OfPackages_ExcludeDependenciesOfThePackage()
    {
        var manifest = RepositoryFiles.Read(RepositoryFiles.Package + "/package.json");

        var needed = ProjectChecks.ForHoloLens().OfType<PackageCheck>().Select(c => c.FixLabel?.Substring("Add ".Length))
            .Where(name => name != null && manifest.Contains("\"" + name + "\""));

        Assert.That(needed, Is.Empty);
    }

    [Test]
    public void Package_Optional_IsOnlyRecommended()
    {
        var check = IndexOf("MRTK3 (optional)");

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Advice));
        Assert.That(_review.Checks[check].FixLabel, Is.Null);
        Assert.That(_review.Results[check].Found, Does.Contain("github.com/MixedRealityToolkit"));
    }

    [Test]
    public void Mrtk3_PartInstalled_NamesTheMissingPackages()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.3.0"));
        _review.Refresh();
        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].Found, Does.StartWith("org.mixedrealitytoolkit.windowsspeech is not installed"));

        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.windowsspeech", "3.0.4"));
        _review.Refresh();
        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));

        PackageInfo.Registered.RemoveAll(p => p.name == "org.mixedrealitytoolkit.uxcomponents");
        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.uxcomponents", "3.2.9"));
        _review.Refresh();
        Assert.That(
            _review.Results[IndexOf("MRTK3 (optional)")].Found,
            Is.EqualTo("org.mixedrealitytoolkit.uxcomponents 3.2.9 is too old; allowed is 3.3.0 or newer, but older than 4.0.0"));
    }

    [Test]
    public void Mrtk3_AllInstalled_IsGood()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input", "windowsspeech" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.4.0"));

        _review.Refresh();

        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void OpenXrSettings_None_AreMissingAndTheFixNamesTheirPlace()
    {
        Project.Open(null);
        _review.Refresh();

        foreach (var title in new[] { "OpenXR feature Mixed Reality Features", "OpenXR Render Mode is Single Pass Instanced" })
        {
            _review.Fix(IndexOf(title));
            Assert.That(_review.Results[IndexOf(title)].State, Is.EqualTo(CheckState.Missing));
            Assert.That(_review.Advice[IndexOf(title)], Does.StartWith("Project Settings, XR Plug-in Management, OpenXR: "));
        }
        Assert.That(EditorApplication.MenuItems, Has.Count.EqualTo(2));
    }

    [Test]
    public void AndroidChecks_EachSetting_FailsBeforeAndPassesAfterItsFix()
    {
        _project = new UnityProjectSettings(HeadsetPlatform.AndroidHeadset);
        _review = new ProjectReview(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), _project);
        foreach (var check in Enumerable.Range(0, _review.Checks.Count).Where(i => _review.Checks[i].FixLabel != null
            && _review.Checks[i] is not (PackageCheck or OpenXrLoaderCheck)))
        {
            Assert.That(_review.Results[check].State, Is.Not.EqualTo(CheckState.Good), _review.Checks[check].Title);
            _review.Fix(check);
            Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good), _review.Checks[check].Title);
        }

        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.Android));
        Assert.That(PlayerSettings.Android.forceInternetPermission);
        var holoLens = new ProjectReview(ProjectChecks.ForHoloLens(), new UnityProjectSettings(HeadsetPlatform.HoloLens2));
        Assert.That(holoLens.Results[IndexIn(holoLens, "Scripting backend is IL2CPP")].State, Is.EqualTo(CheckState.Missing), "of another player");
    }

    [Test]
    public void OpenXrLoader_Fix_OpensTheSettingsAndNamesTheOption()
    {
        var check = IndexOf("OpenXR starts in the UWP player");

        _review.Fix(check);

        Assert.That(EditorApplication.MenuItems, Is.EqualTo(new[] { "Edit/Project Settings..." }));
        Assert.That(_review.Advice[check], Does.Contain("Universal Windows Platform: tick OpenXR"));
    }

    [Test]
    public void GraphicsJobs_TargetSwitched_CanBeTurnedOff()
    {
        var check = IndexOf("Graphics Jobs are off");
        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Unknown));
        _review.Fix(check);
        Assert.That(PlayerSettings.graphicsJobs, "of another target");

        _review.Fix(IndexOf("Build target is Universal Windows Platform"));
        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Advice));
        _review.Fix(check);

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good));
        Assert.That(PlayerSettings.graphicsJobs, Is.False);
    }

    [Test]
    public void Camera_Fixed_CanBeUndoneAndIsSavedWithThePrefabInstance()
    {
        _review.Fix(IndexOf("Main camera's near clip plane is at 0.1 m"));
        _review.Fix(IndexOf("Main camera clears to black with alpha 0"));

        Assert.That(_camera.nearClipPlane, Is.EqualTo(0.1f));
        Assert.That((_camera.clearFlags, _camera.backgroundColor), Is.EqualTo((CameraClearFlags.SolidColor, Color.clear)));
        Assert.That(Undo.Steps, Has.Count.EqualTo(2));
        Assert.That(PrefabUtility.Recorded, Is.EqualTo(new[] { _camera, _camera }));
    }

    [Test]
    public void Camera_BlackButOpaque_IsMissing()
    {
        _camera.clearFlags = CameraClearFlags.SolidColor;
        _camera.backgroundColor = new Color(0, 0, 0, 1);

        _review.Refresh();

        Assert.That(_review.Results[IndexOf("Main camera clears to black with alpha 0")].State, Is.EqualTo(CheckState.Missing));
    }

    [Test]
    public void RenderPipeline_OfTheLevelOrTheDefault_IsNamed()
    {
        var check = IndexOf("Render pipeline is the built-in one or URP");
        Assert.That(_review.Results[check].Found, Does.StartWith("built-in"));

        var graphics = Keep(ScriptableObject.CreateInstance<GraphicsAssetOfATest>());
        graphics.m_CustomRenderPipeline = Keep(ScriptableObject.CreateInstance<HDRenderPipelineAsset>());
        Project.Put("ProjectSettings/GraphicsSettings.asset", graphics);
        _review.Refresh();
        Assert.That(_review.Results[check].Found, Does.StartWith("HDRP"));

        QualitySettings.renderPipeline = Keep(ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>());
        _review.Refresh();
        Assert.That(_review.Results[check].Found, Does.StartWith("URP"));
    }

    [Test]
    public void UnityVersion_OfThisEditor_IsChecked()
    {
        Assert.That(_review.Results[IndexOf("The Unity version has been tested")].Found, Does.StartWith("2022.3.62f1: compiled against 2022.3.7"));
    }

    [Test]
    public void Package_OfMicrosoft_KeepsTheManifestsFormatAndABackup()
    {
        using var folder = new ProjectFolder();
        const string before = "{\r\n\t\"dependencies\": {\r\n\t}\r\n}\r\n";
        folder.Write("Packages/manifest.json", [0xEF, 0xBB, 0xBF, .. System.Text.Encoding.UTF8.GetBytes(before)]);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        var after = File.ReadAllBytes(Path.Combine(folder.Root, "Packages/manifest.json"));
        Assert.That(after.Take(3), Is.EqualTo(new byte[] { 0xEF, 0xBB, 0xBF }));
        Assert.That(System.Text.Encoding.UTF8.GetString(after), Does.Contain("{\r\n\t\t\"com.microsoft.mixedreality.openxr\": \"1.11.2\"\r\n\t}"));
        Assert.That(folder.Read("Packages/manifest.json.backup"), Is.EqualTo(before));
    }

    int IndexOf(string title) => IndexIn(_review, title);

    static int IndexIn(ProjectReview review, string title) => review.Checks.Select(c => c.Title).ToList().IndexOf(title);

    // The fields of ProjectSettings.asset and GraphicsSettings.asset that the checks read.
    sealed class PlayerAssetOfATest : ScriptableObject
    {
        public int activeInputHandler;
    }

    sealed class GraphicsAssetOfATest : ScriptableObject
    {
        public RenderPipelineAsset m_CustomRenderPipeline;
    }

    sealed class UniversalRenderPipelineAsset : RenderPipelineAsset
    {
    }

    sealed class HDRenderPipelineAsset : RenderPipelineAsset
    {
    }
}
