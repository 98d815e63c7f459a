using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests what inspectors show, and what their buttons do, in edit mode.</summary>
public sealed class EditModeInspectorTests : EditorFixture
{
    const string BuildButton = "Build 'youBot' here";

    [Test]
    public void RigInspector_ButtonClicked_BuildsTheSessionsRobotWithUndo()
    {
        var rig = NewRig("youbot");

        Click(rig, BuildButton);

        var root = rig.transform.GetChild(0);
        Assert.That(Undo.Created, Is.EqualTo(new[] { root.gameObject }));
        Assert.That(Undo.Steps, Is.EqualTo(new[] { "Build youBot" }));
        rig.Bind(RobotFiles.Load("youbot"));
        Assert.That(rig.Link(rig.Model.Root.Name), Is.SameAs(root), "the existing root object is used, and no second one is built");
    }

    [Test]
    public void RigInspector_RobotBuilt_IsNotReplacedByAnotherRobot()
    {
        var rig = NewRig("youbot");
        Click(rig, BuildButton);
        var root = rig.transform.GetChild(0);
        rig.Bind(RobotFiles.Load("youbot"));

        Assert.That(() => rig.Bind(RobotFiles.Load("ur5")), Throws.Exception);

        Assert.That(root != null);
    }

    [Test]
    public void RigInspector_LinksExist_HasNoButtonAndMovesNoLink()
    {
        var rig = NewRig("youbot");
        Click(rig, BuildButton);
        var link = rig.transform.Find("arm_link_0/arm_link_1");
        link.localRotation = Quaternion.Euler(0, 30, 0);
        GuiRecorder.Clear();

        Inspect(rig).OnInspectorGUI();

        Assert.That(GuiRecorder.Buttons, Does.Not.Contain(BuildButton));
        Assert.That(link.localEulerAngles.y, Is.EqualTo(30).Within(1e-3));
    }

    [Test]
    public void RigInspector_RobotNotAppearing_AddsAPoseAppearanceWithUndo()
    {
        var rig = NewRig(null);

        Click(rig, InspectorTexts.AddAppearance);

        Assert.That(rig.GetComponent<PoseAppearance>().Substitute, Is.SameAs(PackageAsset.Hologram.Load<Material>()));
        Assert.That(Undo.Steps, Is.EqualTo(new[] { "Add PoseAppearance" }));
        GuiRecorder.Clear();
        Inspect(rig).OnInspectorGUI();
        Assert.That(GuiRecorder.Buttons, Is.Empty);
    }

    [Test]
    public void RigInspector_AppearanceAboveOrNoSession_AsksForNone()
    {
        var below = NewRig(null);
        below.transform.parent.gameObject.AddComponent<PoseAppearance>();

        Inspect(below).OnInspectorGUI();
        Inspect(Keep(new GameObject("alone")).AddComponent<RobotRig>()).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Not.Contain(ShortcomingTexts.Appearance));
    }

    [Test]
    public void RigInspector_InvalidDescription_StatesTheReason()
    {
        var rig = NewRig("youbot");
        rig.GetComponentInParent<MrilSession>().With("_robot", Keep(RobotDescriptionAsset.Create("youBot", "<robot")));

        Click(rig, BuildButton).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts.Any(text => text.Contains(UrdfMessages.NotWellFormed(""))), string.Join("\n", GuiRecorder.Texts));
        Assert.That(Undo.Steps, Is.Empty);
        Assert.That(rig.transform.childCount, Is.Zero);
    }

    [Test]
    public void RigInspector_SessionWithoutRobot_CannotBuild()
    {
        Inspect(NewRig(null)).OnInspectorGUI();

        Assert.That(GuiRecorder.Buttons, Is.EqualTo(new[] { InspectorTexts.AddAppearance }));
    }

    [Test]
    public void AnchorInspector_AnchorPlaced_ShowsThePoseInUrdfAxes()
    {
        var anchor = NewAnchor();
        // The pose is 3 m forward, 1 m left and 2 m up, turned to the left by 90° as seen from above, with the front raised by 30°.
        anchor.transform.SetPositionAndRotation(new Vector3(-1, 2, 3), Quaternion.Euler(0, -90, 0) * Quaternion.Euler(-30, 0, 0));

        Inspect(anchor).OnInspectorGUI();

        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.BasePosition + ": x 3.000   y 1.000   z 2.000"));
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.BaseRotation + ": 90.0°").And.Contain("Tilted: 30.0°"));
    }

    [TestCase("x + 5 mm, forward", 0, 0, 0.005f)]
    [TestCase("x − 5 mm, back", 0, 0, -0.005f)]
    [TestCase("y + 5 mm, left", -0.005f, 0, 0)]
    [TestCase("y − 5 mm, right", 0.005f, 0, 0)]
    [TestCase("z + 5 mm, up", 0, 0.005f, 0)]
    [TestCase("z − 5 mm, down", 0, -0.005f, 0)]
    public void AnchorInspector_StepButtonClicked_MovesAlongItsOwnAxesWithUndo(string button, float x, float y, float z)
    {
        var anchor = NewAnchor();
        var moved = 0;
        anchor.Moved += () => moved++;
        anchor.transform.SetPositionAndRotation(new Vector3(1, 2, 3), Quaternion.Euler(0, 40, 0));

        Click(anchor, button);

        var step = Quaternion.Inverse(anchor.transform.rotation) * (anchor.transform.position - new Vector3(1, 2, 3));
        Assert.That(Vector3.Distance(step, new Vector3(x, y, z)), Is.LessThan(1e-6));
        Assert.That(Undo.Steps, Is.EqualTo(new[] { "Nudge Anchor" }));
        Assert.That(PrefabUtility.Recorded, Is.EqualTo(new[] { anchor.transform }));
        Assert.That(moved, Is.EqualTo(1));
    }

    [TestCase("0.5° to the left", -0.5f)]
    [TestCase("0.5° to the right", 0.5f)]
    public void AnchorInspector_TurnButtonClicked_RotatesAboutTheVertical(string button, float degrees)
    {
        var anchor = NewAnchor();

        Click(anchor, button);

        Assert.That(anchor.transform.eulerAngles.y, Is.EqualTo((360 + degrees) % 360).Within(1e-3));
    }

    RobotRig NewRig(string robot)
    {
        var session = Keep(new GameObject("Cell")).AddComponent<MrilSession>();
        if (robot != null) session.With("_robot", Keep(RobotDescriptionAsset.Create("youBot", RobotFiles.LoadText(robot))));
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        rig.transform.SetParent(session.transform);
        return rig;
    }

    BaseAnchor NewAnchor() => Keep(new GameObject("Anchor")).AddComponent<BaseAnchor>();

    UnityEditor.Editor Inspect(Component component) => Keep(UnityEditor.Editor.CreateEditor(component));

    UnityEditor.Editor Click(Component component, string button)
    {
        var editor = Inspect(component);
        GuiRecorder.Click = button;
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Click, Is.Null, "no such button");
        return editor;
    }
}
