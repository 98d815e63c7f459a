using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;

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

    // Passthrough shows the real robot only where the camera's picture has alpha 0.
    [Test]
    public void Checks_ForAndroid_ContainTheBackgroundOfTheCamera() =>
        Assert.That(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), Does.Contain(RenderingChecks.CameraBackground));
}
