using Nowpose.Editor;
using Nowpose.Editor.Messages;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the button of a session's inspector that shows another robot in a cell of the package.</summary>
public sealed class CellRobotTests : EditorFixture
{
    const string Imported = "Packages/com.nowpose.mril/Runtime/Robots/ur5.urdf";
    const string Described = "Packages/com.nowpose.mril/Runtime/Robots/UR5.asset";

    [Test]
    public void Session_ImportedRobotAssigned_ShowsItInBothRigs()
    {
        var session = Cell(PackageAsset.RobotCell, Imported);
        var gripper = Rigs(session)[0].GetComponentInChildren<VirtualGripper>(true);

        Click(session);

        Assert.That(Rigs(session).Select(rig => rig.name), Is.EqualTo(new[] { "Robot", "Ghost" }));
        foreach (var rig in Rigs(session))
        {
            Assert.That(() => rig.Bind(session.RobotAsset.Read()), Throws.Nothing);
            Assert.That(rig.GetComponentsInChildren<PoseAppearance>(true), Has.Length.EqualTo(1));
            Assert.That(rig.GetComponentsInChildren<VirtualGripper>(true), Has.Length.EqualTo(1), "the gripper follows the flange of the new robot");
            Assert.That(rig.transform.Find("ur5/base_link"), Is.Not.Null, "an instance of the imported prefab");
        }
        Assert.That(gripper != null && gripper.transform.parent == Rigs(session)[0].transform);
        Assert.That(PrefabUtility.GetOutermostPrefabInstanceRoot(session.gameObject), Is.Null, "a part of an instance cannot be removed");
        Assert.That(Undo.Created, Has.Count.EqualTo(2));
        Assert.That(Inspected(session), Is.Empty);
    }

    [Test]
    public void Session_ImportedRobotShown_GhostHasItsMaterialAndStaysHidden()
    {
        var session = Cell(PackageAsset.RobotCell, Imported);

        Click(session);

        var ghost = session.GetComponentInChildren<Ghost>(true);
        var drawn = ghost.transform.Find("ur5").GetComponentsInChildren<MeshFilter>(true).Select(part => part.GetComponent<Renderer>()).ToArray();
        Assert.That(drawn, Is.Not.Empty);
        Assert.That(drawn.Select(part => part.sharedMaterial.name), Is.All.EqualTo("Ghost"));
        Assert.That(PrefabUtility.Recorded, Is.EquivalentTo(drawn));
        Assert.That((ghost.Visible, ghost.GetComponent<RobotRig>().Shows), Is.EqualTo((false, RigPose.Held)));
    }

    [Test]
    public void Session_ImportedRobotInTheCellForAnyRobot_KeepsThePrefabInstance()
    {
        var session = Cell(PackageAsset.RobotCellAny, Imported);

        Click(session);

        foreach (var rig in Rigs(session)) Assert.That(() => rig.Bind(session.RobotAsset.Read()), Throws.Nothing);
        Assert.That(PrefabUtility.GetOutermostPrefabInstanceRoot(session.gameObject), Is.SameAs(session.gameObject));
    }

    [Test]
    public void Session_HolderOfATool_StaysWithItsTool()
    {
        var session = Cell(PackageAsset.RobotCell, Imported);
        var holder = Keep(new GameObject("Mount"));
        holder.transform.SetParent(Rigs(session)[0].transform);
        var tool = new GameObject("Tool").AddComponent<VirtualGripper>();
        tool.gameObject.AddComponent<MeshFilter>();
        tool.transform.SetParent(holder.transform);

        Click(session);

        Assert.That(holder != null && tool != null && tool.transform.parent == holder.transform);
    }

    [Test]
    public void Session_ObjectsOfTheUserBelowARig_AreListedBeforeTheyAreRemoved()
    {
        var session = Cell(PackageAsset.RobotCell, Imported);
        var rig = Rigs(session)[0];
        var links = rig.transform.Cast<Transform>().Single(child => child.GetComponentInChildren<MeshFilter>(true) != null).name;
        var table = Keep(new GameObject("Table"));
        table.AddComponent<MeshFilter>();
        table.transform.SetParent(rig.transform);
        Inspected(session);
        var described = GuiRecorder.Texts.Single(text => text.Contains("Table"));

        Click(session);

        Assert.That(described, Does.Contain($"Robot/{links}, Robot/Table, Ghost/{links}"));
        Assert.That(table == null, "the object is removed");
    }

    [Test]
    public void Session_DescriptionWithoutPrefab_IsBuiltFromItsShapes()
    {
        var session = Cell(PackageAsset.RobotCell, Described);

        Click(session);

        foreach (var rig in Rigs(session)) Assert.That(rig.transform.Find("base_link"), Is.Not.Null);
        Assert.That(Rigs(session)[1].transform.Find("base_link").GetComponentInChildren<Renderer>(true).sharedMaterial.name, Is.EqualTo("Ghost"));
    }

    [Test]
    public void Session_RobotOfThePrefab_HasNoButton() => Assert.That(Inspected(Cell(PackageAsset.RobotCell, null)), Is.Empty);

    [Test]
    public void Session_DescriptionInTheCellForAnyRobot_HasNoButton() =>
        Assert.That(Inspected(Cell(PackageAsset.RobotCellAny, Described)), Is.Empty, "the rig builds this robot at run time");

    MrilSession Cell(PackageAsset prefab, string robot)
    {
        var session = Keep(CellMenu.Place(prefab, null)).GetComponent<MrilSession>();
        if (robot != null) session.With("_robot", AssetDatabase.LoadAllAssetsAtPath(robot).OfType<RobotDescriptionAsset>().Single());
        Undo.Clear();
        return session;
    }

    void Click(MrilSession session)
    {
        GuiRecorder.Click = InspectorTexts.ShowRobot(session.RobotAsset.name);
        Keep(UnityEditor.Editor.CreateEditor(session)).OnInspectorGUI();
        Assert.That(GuiRecorder.Click, Is.Null, "no such button");
    }

    // Returns the buttons of the inspector.
    IEnumerable<string> Inspected(MrilSession session)
    {
        GuiRecorder.Clear();
        Keep(UnityEditor.Editor.CreateEditor(session)).OnInspectorGUI();
        return GuiRecorder.Buttons.ToArray();
    }

    static RobotRig[] Rigs(MrilSession session) => session.gameObject.GetComponentsInChildren<RobotRig>(true);
}
