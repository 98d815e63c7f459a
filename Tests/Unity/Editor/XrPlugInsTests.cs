using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests with assets that have the serialised fields of XR Plug-in Management.</summary>
public sealed class XrPlugInsTests : EditorFixture
{
    [Test]
    public void UseOpenXr_NoSettings_IsNull()
    {
        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.Null);
    }

    [Test]
    public void UseOpenXr_Enabled_IsTrueOnlyForThatPlayer()
    {
        Put((BuildTargetGroup.Standalone, Settings()), (BuildTargetGroup.WSA, Settings(New<OtherLoader>(), New<OpenXRLoader>())));

        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.True);
        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.Standalone), Is.False);
        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.Android), Is.Null);
    }

    [Test]
    public void UseOpenXr_LoaderWithoutPreInit_IsTrue()
    {
        Put((BuildTargetGroup.WSA, Settings(New<OpenXRLoaderNoPreInit>())));

        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.True);
    }

    [Test]
    public void UseOpenXr_OtherPlugInOnly_IsFalse()
    {
        Put((BuildTargetGroup.WSA, Settings(New<OtherLoader>())));

        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.False);
    }

    [Test]
    public void UseOpenXr_LoaderMissing_IsFalse()
    {
        Put((BuildTargetGroup.WSA, Settings((ScriptableObject)null)));

        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.False);
    }

    [Test]
    public void UseOpenXr_UnknownSettingsFormat_IsNull()
    {
        var settings = New<XRGeneralSettings>();
        Put((BuildTargetGroup.WSA, settings));

        Assert.That(XrPlugIns.UseOpenXr(BuildTargetGroup.WSA), Is.Null);
    }

    void Put(params (BuildTargetGroup Player, XRGeneralSettings Settings)[] settings)
    {
        var all = New<XRGeneralSettingsPerBuildTarget>();
        all.Keys = settings.Select(s => s.Player).ToList();
        all.Values = settings.Select(s => s.Settings).ToList();
        Project.Put("Assets/XR/XRGeneralSettings.asset", all);
    }

    XRGeneralSettings Settings(params ScriptableObject[] loaders)
    {
        var manager = New<XRManagerSettings>();
        manager.m_Loaders = loaders.ToList();
        var settings = New<XRGeneralSettings>();
        settings.m_LoaderManagerInstance = manager;
        return settings;
    }

    T New<T>() where T : ScriptableObject => Keep(ScriptableObject.CreateInstance<T>());

    sealed class XRGeneralSettingsPerBuildTarget : ScriptableObject
    {
        public List<BuildTargetGroup> Keys;
        public List<XRGeneralSettings> Values;
    }

    sealed class XRGeneralSettings : ScriptableObject
    {
        public XRManagerSettings m_LoaderManagerInstance;
    }

    sealed class XRManagerSettings : ScriptableObject
    {
        public List<ScriptableObject> m_Loaders;
    }

    // As in com.unity.xr.openxr, both loaders derive from one base class and not from each other.
    abstract class OpenXRLoaderBase : ScriptableObject { }

    sealed class OpenXRLoader : OpenXRLoaderBase { }

    sealed class OpenXRLoaderNoPreInit : OpenXRLoaderBase { }

    sealed class OtherLoader : ScriptableObject { }
}
