using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEngine;
using UnityEngine.Rendering;
using static Nowpose.Unity.Tests.Editor.ReviewedProject;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the project checks with the settings of the stand-in editor.</summary>
public sealed class ProjectChecksTests : EditorFixture
{
    ReviewedProject _reviewed;

    [SetUp]
    public void SetUp() => _reviewed = new ReviewedProject(this);

    static IEnumerable<string> SettingChecks => ProjectChecks.ForHoloLens()
        .Where(c => ReviewedProject.ChangesSetting(c) && c != RenderingChecks.GraphicsJobs).Select(c => c.Title);

    [TestCaseSource(nameof(SettingChecks))]
    public void Check_Setting_FailsBeforeAndPassesAfterItsFix(string title)
    {
        var check = _reviewed.IndexOf(title);
        Assert.That(_reviewed.Review.Results[check].State, Is.Not.EqualTo(CheckState.Good), "before");

        _reviewed.Review.Fix(check);
        RestartTheEditor();

        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Good), _reviewed.Review.Results[check].Found);
        Assert.That(_reviewed.Review.Advice[check], Is.Null);
    }

    void RestartTheEditor()
    {
        SessionState.Clear();
        _reviewed.Review.Refresh();
    }

    [Test]
    public void InputHandling_Fixed_IsMissingUntilTheEditorRestarts()
    {
        var check = _reviewed.IndexOf(CheckTitles.InputHandling);

        _reviewed.Review.Fix(check);
        _reviewed.Review.Refresh();

        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Missing));
        Assert.That(_reviewed.Review.Results[check].Found, Is.EqualTo(CheckResults.AfterRestart(CheckTitles.InputSystem)));
        RestartTheEditor();
        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Good));
    }

    [TestCaseSource(nameof(SettingChecks))]
    public void Fix_OneSetting_DoesNotChangeOtherSettings(string title)
    {
        var before = _reviewed.Review.Results.ToArray();

        _reviewed.Review.Fix(_reviewed.IndexOf(title));
        RestartTheEditor();

        var changed = Enumerable.Range(0, before.Length).Where(i => before[i].State != _reviewed.Review.Results[i].State);
        // Excludes Graphics Jobs: Unity reports this setting only for the active build target, which another fix may change.
        Assert.That(changed.Where(i => _reviewed.Review.Checks[i] != RenderingChecks.GraphicsJobs), Is.EqualTo(new[] { _reviewed.IndexOf(title) }));
    }

    [Test]
    public void Look_AllChecks_DoNotChangeTheProject()
    {
        for (var i = 0; i < 3; i++) _reviewed.Review.Refresh();

        Assert.That(_reviewed.Review.MissingCount, Is.EqualTo(18));
        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.StandaloneWindows64));
        Assert.That(EditorUserBuildSettings.wsaArchitecture, Is.EqualTo("x64"));
        Assert.That(PlayerSettings.runInBackground | PlayerSettings.enableFrameTimingStats, Is.False);
        Assert.That(PlayerSettings.GetUseDefaultGraphicsAPIs(BuildTarget.WSAPlayer) & PlayerSettings.graphicsJobs);
        Assert.That(_reviewed.Camera.nearClipPlane, Is.EqualTo(0.02f));
        Assert.That(Undo.Steps, Is.Empty);
        Assert.That(Client.Asked, Is.Empty);
        Assert.That(EditorApplication.MenuItems, Is.Empty);
    }

    [Test]
    public void Checks_ForHoloLens_NameTheRequiredCapabilities()
    {
        var capabilities = ProjectChecks.ForHoloLens().Select(check => check.Title)
            .Where(title => title.StartsWith(CheckTitles.Capability(""), StringComparison.Ordinal));

        string[] needed = ["InternetClient", "PrivateNetworkClientServer", "WebCam", "SpatialPerception", "GazeInput", "Microphone"];
        Assert.That(capabilities, Is.EqualTo(needed.Select(CheckTitles.Capability)));
    }

    [TestCase(BuildTarget.StandaloneWindows64, true)]
    [TestCase(BuildTarget.Android, false)]
    public void BuildTarget_OfAPc_StatesThatTheChecksDoNotApply(BuildTarget target, bool isPc)
    {
        EditorUserBuildSettings.SwitchActiveBuildTarget(UnityEditor.Build.NamedBuildTarget.Android, target);
        _reviewed.Review.Refresh();

        var found = _reviewed.Review.Results[_reviewed.IndexOf(CheckTitles.BuildTarget(HeadsetPlatform.HoloLens2.Player))].Found;

        Assert.That(found.EndsWith(CheckResults.PcHeadset, StringComparison.Ordinal), Is.EqualTo(isPc), found);
    }

    [Test]
    public void BuildTarget_EditorWithoutUwp_NamesTheRemedy()
    {
        EditorUserBuildSettings.HasUwp = false;
        var check = _reviewed.IndexOf(CheckTitles.BuildTarget(HeadsetPlatform.HoloLens2.Player));

        _reviewed.Review.Fix(check);

        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Missing));
        Assert.That(_reviewed.Review.Advice[check], Is.EqualTo(CheckFixes.BuildSupport(HeadsetPlatform.HoloLens2.Player)));
    }

    [Test]
    public void OpenXrSettings_Missing_FixOpensTheProjectSettingsAndNamesThePage()
    {
        Project.Open(null);
        _reviewed.Review.Refresh();

        foreach (var (title, advice) in new[]
        {
            (CheckTitles.Feature("Mixed Reality Features"), CheckFixes.Feature("Mixed Reality Features")),
            (CheckTitles.OpenXrOption("Render Mode", "Single Pass Instanced"), CheckFixes.OpenXrOption("Render Mode", "Single Pass Instanced")),
        })
        {
            _reviewed.Review.Fix(_reviewed.IndexOf(title));
            Assert.That(_reviewed.Review.Results[_reviewed.IndexOf(title)].State, Is.EqualTo(CheckState.Missing));
            Assert.That(_reviewed.Review.Advice[_reviewed.IndexOf(title)], Is.EqualTo(advice));
        }
        Assert.That(EditorApplication.MenuItems, Has.Count.EqualTo(2));
    }

    [Test]
    public void AndroidChecks_EachSetting_FailsBeforeAndPassesAfterItsFix()
    {
        _reviewed.Settings = new UnityProjectSettings(HeadsetPlatform.AndroidHeadset);
        _reviewed.Review = new ProjectReview(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), _reviewed.Settings);
        foreach (var check in Enumerable.Range(0, _reviewed.Review.Checks.Count)
            .Where(i => ReviewedProject.ChangesSetting(_reviewed.Review.Checks[i])))
        {
            Assert.That(_reviewed.Review.Results[check].State, Is.Not.EqualTo(CheckState.Good), _reviewed.Review.Checks[check].Title);
            _reviewed.Review.Fix(check);
            RestartTheEditor();
            Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Good), _reviewed.Review.Checks[check].Title);
        }

        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.Android));
        Assert.That(PlayerSettings.Android.forceInternetPermission);
        var holoLens = new ProjectReview(ProjectChecks.ForHoloLens(), new UnityProjectSettings(HeadsetPlatform.HoloLens2));
        Assert.That(holoLens.Results[IndexIn(holoLens, "Scripting backend is IL2CPP")].State, Is.EqualTo(CheckState.Missing), "this is a setting of another player");
    }

    [Test]
    public void OpenXrLoader_Fix_OpensTheSettingsAndNamesTheOption()
    {
        var check = _reviewed.IndexOf(CheckTitles.OpenXrLoader(HeadsetPlatform.HoloLens2.ShortPlayer));

        _reviewed.Review.Fix(check);

        Assert.That(EditorApplication.MenuItems, Is.EqualTo(new[] { "Edit/Project Settings..." }));
        Assert.That(_reviewed.Review.Advice[check], Is.EqualTo(CheckFixes.OpenXrLoader(HeadsetPlatform.HoloLens2.Player)));
    }

    [Test]
    public void GraphicsJobs_TargetSwitched_CanBeTurnedOff()
    {
        var check = _reviewed.IndexOf(CheckTitles.GraphicsJobs);
        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Unknown));
        _reviewed.Review.Fix(check);
        Assert.That(PlayerSettings.graphicsJobs, "this is a setting of another build target");

        _reviewed.Review.Fix(_reviewed.IndexOf(CheckTitles.BuildTarget(HeadsetPlatform.HoloLens2.Player)));
        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Advice));
        _reviewed.Review.Fix(check);

        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Good));
        Assert.That(PlayerSettings.graphicsJobs, Is.False);
    }

    [Test]
    public void Camera_Fixed_CanBeUndoneAndIsSavedWithThePrefabInstance()
    {
        _reviewed.Review.Fix(_reviewed.IndexOf(CheckTitles.NearClip));
        _reviewed.Review.Fix(_reviewed.IndexOf(CheckTitles.CameraBackground));

        Assert.That(_reviewed.Camera.nearClipPlane, Is.EqualTo(0.1f));
        Assert.That((_reviewed.Camera.clearFlags, _reviewed.Camera.backgroundColor), Is.EqualTo((CameraClearFlags.SolidColor, Color.clear)));
        Assert.That(Undo.Steps, Has.Count.EqualTo(2));
        Assert.That(PrefabUtility.Recorded, Is.EqualTo(new[] { _reviewed.Camera, _reviewed.Camera }));
    }

    // MRTK3's rig overwrites the camera at run time.
    [Test]
    public void Camera_BelowTheRigOfMrtk3_ChecksReadAndFixTheSettingsOfTheRig()
    {
        var rig = Keep(new GameObject("Rig")).AddComponent<CameraSettingsManager>();
        _reviewed.Camera.transform.SetParent(rig.transform);
        int near = _reviewed.IndexOf(CheckTitles.NearClip), background = _reviewed.IndexOf(CheckTitles.CameraBackground);
        _reviewed.Review.Refresh();
        Assert.That(_reviewed.Review.Results[near].State, Is.EqualTo(CheckState.Good), "0.1 m in the rig, 0.02 m in the camera");
        rig.Transparent.Near = 0.01f;

        _reviewed.Review.Refresh();
        Assert.That((_reviewed.Review.Results[near].State, _reviewed.Review.Results[background].State), Is.EqualTo((CheckState.Missing, CheckState.Missing)));
        _reviewed.Review.Fix(near);
        _reviewed.Review.Fix(background);

        Assert.That((_reviewed.Review.Results[near].State, _reviewed.Review.Results[background].State), Is.EqualTo((CheckState.Good, CheckState.Good)));
        Assert.That((rig.Transparent.Near, rig.Transparent.Mode, rig.Transparent.Colour), Is.EqualTo((0.1f, CameraClearFlags.SolidColor, Color.clear)));
        Assert.That(_reviewed.Camera.nearClipPlane, Is.EqualTo(0.02f));
    }

    [Test]
    public void Camera_ClearsToOpaqueBlack_CheckReportsTheSettingAsMissing()
    {
        _reviewed.Camera.clearFlags = CameraClearFlags.SolidColor;
        _reviewed.Camera.backgroundColor = new Color(0, 0, 0, 1);

        _reviewed.Review.Refresh();

        Assert.That(_reviewed.Review.Results[_reviewed.IndexOf(CheckTitles.CameraBackground)].State, Is.EqualTo(CheckState.Missing));
    }

    [Test]
    public void RenderPipeline_OfTheQualityLevelOrTheDefault_IsNamed()
    {
        var check = _reviewed.IndexOf(CheckTitles.RenderPipeline);
        Assert.That(_reviewed.Review.Results[check].Found, Is.EqualTo(CheckResults.BuiltIn));

        var graphics = Keep(ScriptableObject.CreateInstance<GraphicsAssetOfATest>());
        graphics.m_CustomRenderPipeline = Keep(ScriptableObject.CreateInstance<HDRenderPipelineAsset>());
        Project.Put("ProjectSettings/GraphicsSettings.asset", graphics);
        _reviewed.Review.Refresh();
        Assert.That(_reviewed.Review.Results[check].Found, Does.StartWith("HDRP"));

        QualitySettings.renderPipeline = Keep(ScriptableObject.CreateInstance<UniversalRenderPipelineAsset>());
        _reviewed.Review.Refresh();
        Assert.That(_reviewed.Review.Results[check].Found, Does.StartWith("URP"));
    }

    [Test]
    public void UnityVersion_RunningEditor_IsChecked()
    {
        Assert.That(
            _reviewed.Review.Results[_reviewed.IndexOf(CheckTitles.UnityVersion)].Found,
            Does.StartWith("2022.3.62f1: " + UnityVersionMessages.Compared2022));
    }

    // Contains the field of GraphicsSettings.asset that the checks read.
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

    // The names are those of MRTK3's component.
    sealed class CameraSettingsManager : MonoBehaviour
    {
        [SerializeField] CameraSettings transparentDisplay = new();

        public CameraSettings Transparent => transparentDisplay;
    }

    [Serializable]
    sealed class CameraSettings
    {
        [SerializeField] CameraClearFlags clearMode = CameraClearFlags.Skybox;
        [SerializeField] Color clearColor = new(0, 0, 0, 1);
        [SerializeField] float nearPlaneDistance = 0.1f;

        public float Near { get => nearPlaneDistance; set => nearPlaneDistance = value; }

        public CameraClearFlags Mode => clearMode;

        public Color Colour => clearColor;
    }
}
