using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the checks of a project for an Android headset.</summary>
public sealed class AndroidChecksTests : EditorFixture
{
    [TestCase(AndroidArchitecture.ARM64, true)]
    [TestCase(AndroidArchitecture.ARM64 | AndroidArchitecture.X86_64, true)]
    [TestCase(AndroidArchitecture.X86_64, false)]
    public void ScriptingBackend_Mono_IsMissingOnAndroidOnlyForArm64(AndroidArchitecture architectures, bool isMissing)
    {
        PlayerSettings.Android.targetArchitectures = architectures;

        Assert.That(StateOnMono(HeadsetPlatform.AndroidHeadset), Is.EqualTo(isMissing ? CheckState.Missing : CheckState.Advice));
        Assert.That(StateOnMono(HeadsetPlatform.HoloLens2), Is.EqualTo(CheckState.Missing), "the UWP player supports only IL2CPP");
    }

    static CheckState StateOnMono(HeadsetPlatform platform)
    {
        var settings = new UnityProjectSettings(platform) { UsesIl2Cpp = false };
        return ProjectChecks.For(platform).Single(check => check.Title == CheckTitles.ScriptingBackend).Look(settings).State;
    }

    // Without a depth buffer, the display of a Magic Leap 2 corrects for the motion of the head at one distance only.
    [TestCase("Depth Submission Mode", "Depth 16 Bit")]
    [TestCase("Latency Optimization", "Prioritize Rendering")]
    public void Checks_ForAndroid_AdviseOpenXrOptions(string option, string value)
    {
        OpenXrAssets.Put(Keep, BuildTargetGroup.Android);
        var check = ProjectChecks.For(HeadsetPlatform.AndroidHeadset).SingleOrDefault(each => each.Title == CheckTitles.OpenXrOption(option, value));

        Assert.That(check, Is.Not.Null);
        Assert.That(check.Look(new UnityProjectSettings(HeadsetPlatform.AndroidHeadset)).State, Is.EqualTo(CheckState.Advice));
    }

    // The option exists in version 1.15 and newer of the OpenXR plug-in.
    [Test]
    public void LatencyOptimization_WithoutTheOption_IsGoodOnlyIfThereAreSettings([Values] bool hasSettings)
    {
        if (hasSettings) OpenXrAssets.PutOld(Keep, BuildTargetGroup.WSA);
        var check = ProjectChecks.ForHoloLens()
            .SingleOrDefault(each => each.Title == CheckTitles.OpenXrOption("Latency Optimization", "Prioritize Rendering"));

        Assert.That(check, Is.Not.Null);
        var found = check.Look(new UnityProjectSettings(HeadsetPlatform.HoloLens2));
        Assert.That((found.State, found.Found), Is.EqualTo(
            hasSettings ? (CheckState.Good, CheckResults.NoLatencyOptimization) : (CheckState.Advice, CheckResults.NoOpenXrSettings)));
    }

    // Passthrough shows the real robot only where the camera's picture has alpha 0.
    [Test]
    public void Checks_ForAndroid_ContainTheBackgroundOfTheCamera() =>
        Assert.That(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), Does.Contain(RenderingChecks.CameraBackground));

    // The camera of XR Interaction Toolkit's XR Origin has its near clip plane at 0.01 m. A 16-bit depth buffer then has steps of 3.4 mm at 1.5 m.
    [Test]
    public void Checks_ForAndroid_AdviseTheNearClipPlane()
    {
        Keep(new GameObject("Camera") { tag = "MainCamera" }).AddComponent<Camera>().nearClipPlane = 0.01f;
        var check = ProjectChecks.For(HeadsetPlatform.AndroidHeadset).SingleOrDefault(each => each.Title == CheckTitles.NearClip);

        Assert.That(check, Is.Not.Null);
        Assert.That(check.Look(new UnityProjectSettings(HeadsetPlatform.AndroidHeadset)).State, Is.EqualTo(CheckState.Advice));
    }
}
