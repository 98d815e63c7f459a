using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

public sealed class SetupWindowTests : EditorFixture
{
    SetupWindow _window;

    [SetUp]
    public void SetUp() => _window = Keep(ScriptableObject.CreateInstance<SetupWindow>());

    [Test]
    public void Draw_NewProject_ListsMissingItemsAndChangesNothing()
    {
        Send("OnGUI");

        Assert.That(GuiRecorder.Texts[2], Is.EqualTo(SetupTexts.Summary(15, HeadsetPlatform.HoloLens2.Headset)));
        Assert.That(GuiRecorder.Texts, Does.Contain("✗ " + CheckTitles.ScriptingBackend));
        Assert.That(GuiRecorder.Texts, Does.Contain("missing: " + CheckResults.ScriptingBackend));
        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.StandaloneWindows64));
        Assert.That(Client.Asked, Is.Empty);
    }

    [Test]
    public void Click_OnAFix_AppliesOnlyThatFix()
    {
        GuiRecorder.Click = CheckTitles.Declare("WebCam");
        Send("OnGUI");
        Assert.That(PlayerSettings.WSA.GetCapability(PlayerSettings.WSACapability.WebCam), Is.False, "the check runs while the window is drawn");
        EditorApplication.RunDelayed();
        GuiRecorder.Clear();
        Send("OnGUI");

        Assert.That(GuiRecorder.Texts[2], Is.EqualTo(SetupTexts.Summary(14, HeadsetPlatform.HoloLens2.Headset)));
        Assert.That(GuiRecorder.Texts, Does.Contain("✓ " + CheckTitles.Capability("WebCam")));
        Assert.That(GuiRecorder.Buttons, Does.Not.Contain(CheckTitles.Declare("WebCam")));
        Assert.That(PlayerSettings.WSA.GetCapability(PlayerSettings.WSACapability.WebCam));
        Assert.That(PlayerSettings.WSA.GetCapability(PlayerSettings.WSACapability.InternetClient), Is.False);
    }

    [Test]
    public void Focus_AfterAnExternalChange_ShowsTheChange()
    {
        PlayerSettings.enableFrameTimingStats = true;

        Send("OnFocus");
        Send("OnGUI");

        Assert.That(GuiRecorder.Texts, Does.Contain("✓ " + CheckTitles.FrameTiming));
    }

    [Test]
    public void Click_WindowAlreadyClosed_HasNoEffect()
    {
        GuiRecorder.Click = CheckTitles.Declare("WebCam");
        Send("OnGUI");
        UnityEngine.Object.DestroyImmediate(_window);

        EditorApplication.RunDelayed();

        Assert.That(PlayerSettings.WSA.GetCapability(PlayerSettings.WSACapability.WebCam), Is.False);
    }

    [Test]
    public void Click_OnTheOtherHeadset_ListsItsRequirements()
    {
        GuiRecorder.Click = SetupTexts.AndroidHeadset;
        Send("OnGUI");
        Assert.That(GuiRecorder.Texts, Does.Contain("✗ " + CheckTitles.Capability("WebCam")), "changed between a layout and its event");
        EditorApplication.RunDelayed();

        var texts = Draw();

        Assert.That(texts[2], Is.EqualTo(SetupTexts.Summary(8, HeadsetPlatform.AndroidHeadset.Headset)));
        Assert.That(texts, Does.Contain("✗ " + CheckTitles.InternetAccess));
        Assert.That(texts, Has.None.Contains("Capability"));
        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.StandaloneWindows64), "a selection in the list does not switch the build target");
    }

    [Test]
    public void Reload_OtherHeadsetChosen_KeepsTheChoice()
    {
        GuiRecorder.Click = SetupTexts.AndroidHeadset;
        Send("OnGUI");
        EditorApplication.RunDelayed();

        Reload();

        Assert.That(Draw()[2], Is.EqualTo(SetupTexts.Summary(8, HeadsetPlatform.AndroidHeadset.Headset)));
    }

    [Test]
    public void Reload_AfterAFailure_KeepsReasonAndAdvice()
    {
        EditorUserBuildSettings.HasUwp = false;
        GuiRecorder.Click = CheckTitles.SwitchTo("UWP");
        Send("OnGUI");
        EditorApplication.RunDelayed();
        GuiRecorder.Click = CheckTitles.AddPackage("com.unity.xr.openxr");
        Send("OnGUI");
        EditorApplication.RunDelayed();
        Client.Newest.Fail("offline");
        Send("Update");
        var texts = Draw();
        Assert.That(texts, Does.Contain(SetupTexts.PackageNotAdded("com.unity.xr.openxr", "offline")));
        Assert.That(texts, Does.Contain(CheckFixes.BuildSupport(HeadsetPlatform.HoloLens2.Player)));

        Reload();

        Assert.That(Draw(), Is.EqualTo(texts));
    }

    [Test]
    public void Open_ProjectForAndroid_ListsItsRequirements()
    {
        EditorUserBuildSettings.SwitchActiveBuildTarget(UnityEditor.Build.NamedBuildTarget.Android, BuildTarget.Android);

        _window = Keep(ScriptableObject.CreateInstance<SetupWindow>());

        Assert.That(Draw(), Does.Contain("✓ " + CheckTitles.BuildTarget(HeadsetPlatform.AndroidHeadset.Player)));
    }

    [Test]
    public void Click_OnCheckAgain_ShowsTheChange()
    {
        PlayerSettings.enableFrameTimingStats = true;
        GuiRecorder.Click = SetupTexts.CheckAgain;

        Send("OnGUI");
        EditorApplication.RunDelayed();
        Send("OnGUI");

        Assert.That(GuiRecorder.Texts, Does.Contain("✓ " + CheckTitles.FrameTiming));
    }

    [Test]
    public void Update_WhileAPackageIsAdded_ShowsProgressAndResult()
    {
        GuiRecorder.Click = CheckTitles.AddPackage("com.unity.xr.openxr");
        Send("OnGUI");
        EditorApplication.RunDelayed();
        var texts = Draw();
        Assert.That(texts, Does.Contain(SetupTexts.Adding("com.unity.xr.openxr")));

        Client.Newest.Fail("offline");
        Assert.That(Draw(), Is.EqualTo(texts), "changed between a layout and its event");
        Send("Update");

        Assert.That(Draw(), Does.Contain(SetupTexts.PackageNotAdded("com.unity.xr.openxr", "offline")));
        Assert.That(_window.Repaints, Is.EqualTo(2));
    }

    [Test]
    public void Update_PackageUnchanged_DoesNotCheckAgain()
    {
        GuiRecorder.Click = CheckTitles.AddPackage("com.unity.xr.openxr");
        Send("OnGUI");
        EditorApplication.RunDelayed();
        PlayerSettings.enableFrameTimingStats = true;

        for (var tick = 0; tick < 3; tick++) Send("Update");

        Assert.That(Draw(), Does.Not.Contain("✓ " + CheckTitles.FrameTiming));
        Assert.That(_window.Repaints, Is.EqualTo(1));
    }

    [TestCase("Tracked Object", typeof(TrackedObject))]
    [TestCase("Stationary Object", typeof(StationaryObject))]
    [TestCase("Signal", typeof(CellSignal))]
    [TestCase("Actuated Part", typeof(ActuatedPart))]
    [TestCase("Another Robot", typeof(RobotRig))]
    [TestCase("Another Robot", typeof(PoseAppearance))]
    [TestCase("Grip by Reach", typeof(GripByReach))]
    [TestCase("Planned Path", typeof(PlannedPath))]
    public void Click_OnAPart_CreatesItBelowTheSelectedObject(string part, Type component)
    {
        var parent = Keep(new GameObject("base"));
        Selection.activeObject = parent;
        GuiRecorder.Click = part;

        Send("OnGUI");
        Assert.That(parent.transform.childCount, Is.Zero, "the check runs while the window is drawn");
        EditorApplication.RunDelayed();

        var made = Keep((GameObject)Selection.activeObject);
        Assert.That(made.GetComponent(component), Is.Not.Null);
        Assert.That(made.transform.parent, Is.SameAs(parent.transform));
        Assert.That(Undo.Created, Is.EqualTo(new[] { made }));
    }

    [Test]
    public void Click_OnAPartWithAnAssetSelected_CreatesItInTheScene()
    {
        Selection.activeObject = PackageAsset.VirtualGripper.Load<GameObject>();
        Assert.That(EditorUtility.IsPersistent(Selection.activeObject));
        GuiRecorder.Click = "Signal";

        Send("OnGUI");
        EditorApplication.RunDelayed();

        Assert.That(Keep((GameObject)Selection.activeObject).transform.parent, Is.Null);
    }

    [Test]
    public void Menu_Clicked_OpensTheWindow()
    {
        EditorApplication.ExecuteMenuItem("Window/Nowpose/Project Setup");

        Assert.That(_window.Title, Is.EqualTo(SetupTexts.WindowTitle));
    }

    // Unity keeps only the serialised fields when it reloads the scripts.
    void Reload() => _window = Keep(UnityEngine.Object.Instantiate(_window));

    List<string> Draw()
    {
        GuiRecorder.Clear();
        Send("OnGUI");
        return GuiRecorder.Texts.ToList();
    }

    void Send(string message) => RareMessages.Call(_window, message);
}
