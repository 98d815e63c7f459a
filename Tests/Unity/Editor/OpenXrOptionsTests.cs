using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;

namespace Nowpose.Unity.Tests.Editor;

public sealed class OpenXrOptionsTests : EditorFixture
{
    [Test]
    public void IsOn_NoSettings_IsNull()
    {
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.WSA, OpenXrAssets.HoloLens), Is.Null);
        Assert.That(OpenXrOptions.TurnOn(BuildTargetGroup.WSA, OpenXrAssets.HoloLens), Is.False);
        Assert.That(OpenXrOptions.Get(BuildTargetGroup.WSA, "m_renderMode"), Is.Null);
        Assert.That(OpenXrOptions.Set(BuildTargetGroup.WSA, "m_renderMode", 1), Is.False);
    }

    [Test]
    public void TurnOn_FeatureOfOnePlayer_IsOnOnlyForThatPlayer()
    {
        OpenXrAssets.Put(Keep, BuildTargetGroup.Standalone, BuildTargetGroup.WSA);
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.WSA, OpenXrAssets.HoloLens), Is.False);

        Assert.That(OpenXrOptions.TurnOn(BuildTargetGroup.WSA, OpenXrAssets.HoloLens));

        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.WSA, OpenXrAssets.HoloLens), Is.True);
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.WSA, "com.microsoft.openxr.feature.appremoting"), Is.False);
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.Standalone, OpenXrAssets.HoloLens), Is.False);
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.Android, OpenXrAssets.HoloLens), Is.Null);
        Assert.That(OpenXrOptions.IsOn(BuildTargetGroup.WSA, "another"), Is.Null);
    }

    [Test]
    public void Set_OptionOfOnePlayer_AppliesOnlyToThatPlayer()
    {
        OpenXrAssets.Put(Keep, BuildTargetGroup.Android, BuildTargetGroup.WSA);

        Assert.That(OpenXrOptions.Set(BuildTargetGroup.WSA, "m_renderMode", 1));

        Assert.That(OpenXrOptions.Get(BuildTargetGroup.WSA, "m_renderMode"), Is.EqualTo(1));
        Assert.That(OpenXrOptions.Get(BuildTargetGroup.Android, "m_renderMode"), Is.Zero);
        Assert.That(OpenXrOptions.Set(BuildTargetGroup.WSA, "m_another", 1), Is.False);
    }
}
