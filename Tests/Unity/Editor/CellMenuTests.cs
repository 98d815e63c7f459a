using Nowpose.Editor;
using Nowpose.Editor.Messages;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

public sealed class CellMenuTests : EditorFixture
{
    static IEnumerable<TestCaseData> Items => new[]
    {
        new TestCaseData("GameObject/Nowpose/Robot Cell", PackageAsset.RobotCell),
        new TestCaseData("GameObject/Nowpose/Robot Cell UR5", PackageAsset.RobotCellUr5),
        new TestCaseData("GameObject/Nowpose/Robot Cell (Any Robot)", PackageAsset.RobotCellAny),
        new TestCaseData("GameObject/Nowpose/Virtual Gripper", PackageAsset.VirtualGripper),
        new TestCaseData("GameObject/Nowpose/Another youBot", PackageAsset.Robot),
    };

    [TestCaseSource(nameof(Items))]
    public void MenuItem_PrefabExists_PlacesAndSelectsAnInstanceWithUndo(string item, object of)
    {
        var prefab = Put((PackageAsset)of);

        EditorApplication.ExecuteMenuItem(item);

        var instance = Keep((GameObject)Selection.activeObject);
        Assert.That(PrefabUtility.GetCorrespondingObjectFromSource(instance), Is.SameAs(prefab));
        Assert.That(instance.name, Is.EqualTo(prefab.name));
        Assert.That(Undo.Steps, Is.EqualTo(new[] { "Create " + prefab.name }));
        Assert.That(Undo.Created, Is.EqualTo(new[] { instance }));
    }

    [TestCase("Tracked Object", typeof(TrackedObject))]
    [TestCase("Stationary Object", typeof(StationaryObject))]
    [TestCase("Signal", typeof(CellSignal))]
    [TestCase("Actuated Part", typeof(ActuatedPart))]
    [TestCase("Another Robot", typeof(RobotRig))]
    [TestCase("Another Robot", typeof(PoseAppearance))]
    [TestCase("Grip by Reach", typeof(GripByReach))]
    [TestCase("Planned Path", typeof(PlannedPath))]
    public void MenuItem_ForAComponent_CreatesAndSelectsAnObjectWithUndo(string item, Type component)
    {
        EditorApplication.ExecuteMenuItem("GameObject/Nowpose/" + item);

        var made = Keep((GameObject)Selection.activeObject);
        Assert.That(made.GetComponent(component), Is.Not.Null);
        Assert.That(Undo.Created, Is.EqualTo(new[] { made }));
    }

    [TestCase("Tracked Object", false)]
    [TestCase("Stationary Object", false)]
    [TestCase("Signal", false)]
    [TestCase("Signal", true)]
    [TestCase("Actuated Part", false)]
    [TestCase("Actuated Part", true)]
    public void MenuItem_ForAPartOfACell_HasOnePoseAppearanceThatCanMarkEachMaterial(string item, bool isAbove)
    {
        var hologram = Keep(new Material((Shader)null));
        Project.PutAs(PackageAsset.Hologram.Guid, "Hologram.mat", hologram);
        var above = Keep(new GameObject("above"));
        if (isAbove) above.AddComponent<PoseAppearance>();

        var made = MadeBelow(above, item);

        Assert.That(made.GetComponentsInParent<PoseAppearance>(true), Has.Length.EqualTo(1));
        if (!isAbove) Assert.That(made.GetComponent<PoseAppearance>().Substitute, Is.SameAs(hologram));
    }

    [TestCase("Tracked Object")]
    [TestCase("Stationary Object")]
    [TestCase("Signal")]
    [TestCase("Actuated Part")]
    [TestCase("Another Robot")]
    public void MenuItem_ForAPartOfACell_AddsALabel(string item)
    {
        Put(PackageAsset.PoseLabel).AddComponent<TextMesh>();

        var made = MadeBelow(Keep(new GameObject("Base Anchor")), item);

        var label = made.GetComponentInChildren<TextMesh>();
        Assert.That(made.GetComponent<PoseAppearance>().Shown("_words"), Is.Not.Null.And.SameAs(label));
    }

    [Test]
    public void MenuItem_UsedTwice_GivesTheObjectsDifferentFrames()
    {
        var anchor = Keep(new GameObject("Base Anchor"));

        var frames = new[] { "Stationary Object", "Stationary Object", "Tracked Object" }
            .Select(item => MadeBelow(anchor, item)).Select(made => made.name).ToArray();

        Assert.That(frames, Is.EqualTo(new[] { "Stationary Object", "Stationary Object (1)", "Tracked Object" }));
    }

    [TestCase("Grip by Reach", 1)]
    [TestCase("Grip by Reach", 2)]
    [TestCase("Planned Path", 1)]
    [TestCase("Virtual Gripper", 1)]
    [TestCase("Virtual Gripper", 2)]
    public void MenuItem_ForAPartOfARobot_IsBelowTheOnlyDisplayedRig(string item, int displayed)
    {
        Put(PackageAsset.VirtualGripper);
        var anchor = Keep(new GameObject("Base Anchor"));
        var robots = Enumerable.Range(0, displayed).Select(_ => Below<RobotRig>(anchor)).ToArray();
        Below<RobotRig>(anchor).With("_shows", RigPose.Held);

        var made = MadeBelow(anchor, item);

        Assert.That(made.transform.parent, Is.SameAs(displayed == 1 ? robots[0].transform : anchor.transform));
        made = MadeBelow(robots[^1].gameObject, item);
        Assert.That(made.transform.parent, Is.SameAs(robots[^1].transform), "the selected rig");
    }

    [Test]
    public void SetupWindow_Entries_EqualTheMenu()
    {
        var items = MenuItem.All.Where(item => item.Path.StartsWith("GameObject/Nowpose/", StringComparison.Ordinal));

        Assert.That(
            CellMenu.Entries.Select(entry => ("GameObject/Nowpose/" + entry.Name, entry.Create.Method)), Is.EquivalentTo(items),
            "each [MenuItem] of CellMenu needs an entry in CellMenu.Entries");
    }

    [TestCase("Virtual Gripper")]
    [TestCase("Another youBot")]
    [TestCase("Signal")]
    [TestCase("Grip by Reach")]
    public void MenuBar_PartWithAnObjectSelected_CreatesItBelowTheObject(string item)
    {
        Put(PackageAsset.VirtualGripper);
        Put(PackageAsset.Robot);
        var selected = Keep(new GameObject("Base Anchor"));

        var made = MadeBelow(selected, item);

        Assert.That(made.transform.parent, Is.SameAs(selected.transform));
    }

    [Test]
    public void MenuBar_PartWithAnAssetSelected_CreatesItWithoutAParent()
    {
        var asset = PackageAsset.VirtualGripper.Load<GameObject>();
        Assert.That(EditorUtility.IsPersistent(asset));

        var made = MadeBelow(asset, "Signal");

        Assert.That(Keep(made), Is.Not.SameAs(asset));
        Assert.That(made.transform.parent, Is.Null);
    }

    [Test]
    public void Hierarchy_SeveralObjectsSelected_CreatesOnePartBelowTheActiveOne()
    {
        var selected = new[] { "a", "active", "b" }.Select(name => Keep(new GameObject(name))).ToArray();
        Selection.activeObject = selected[1];

        foreach (var each in selected) Click("Signal", each);

        Assert.That(selected.Select(each => each.transform.childCount), Is.EqualTo(new[] { 0, 1, 0 }));
    }

    [Test]
    public void Cell_ObjectSelected_HasNoParent(
        [Values("Robot Cell", "Robot Cell UR5", "Robot Cell (Any Robot)")] string item, [Values] bool isFromTheHierarchy)
    {
        foreach (var prefab in new[] { PackageAsset.RobotCell, PackageAsset.RobotCellUr5, PackageAsset.RobotCellAny }) Put(prefab);
        var camera = Keep(new GameObject("Main Camera"));
        Selection.activeObject = camera;

        Click(item, isFromTheHierarchy ? camera : null);

        Assert.That(Selection.activeObject, Is.Not.SameAs(camera));
        Assert.That(Keep((GameObject)Selection.activeObject).transform.parent, Is.Null);
    }

    [Test]
    public void Place_ParentGiven_PlacesThePrefabBelowIt()
    {
        Put(PackageAsset.VirtualGripper);
        var parent = Keep(new GameObject("parent"));
        parent.transform.position = new Vector3(1, 2, 3);

        var instance = CellMenu.Place(PackageAsset.VirtualGripper, parent);

        Assert.That(instance.transform.parent, Is.SameAs(parent.transform));
        Assert.That(instance.transform.localPosition, Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void Place_PrefabMissing_NamesThePrefabAndTheRemedy()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{}");
        Project.Open(folder.Root);
        var logs = new List<string>();
        Application.LogCallback listen = (message, _, type) => logs.Add(type + ": " + message);
        Application.logMessageReceived += listen;
        try
        {
            Assert.That(CellMenu.Place(PackageAsset.RobotCell, null), Is.Null);
        }
        finally
        {
            Application.logMessageReceived -= listen;
        }

        Assert.That(logs, Is.EqualTo(new[]
        {
            "Error: [Nowpose] " + SetupTexts.PrefabMissing("Nowpose Robot Cell", PackageAsset.RobotCell.Guid),
        }));
        Assert.That(Undo.Steps, Is.Empty);
    }

    static T Below<T>(GameObject parent) where T : Component
    {
        var made = new GameObject(typeof(T).Name);
        made.transform.SetParent(parent.transform);
        return made.AddComponent<T>();
    }

    static GameObject MadeBelow(GameObject selected, string item)
    {
        Selection.activeObject = selected;
        EditorApplication.ExecuteMenuItem("GameObject/Nowpose/" + item);
        return (GameObject)Selection.activeObject;
    }

    // Executes a menu item for an object in the Hierarchy, or without a context, as the menu bar does.
    static void Click(string item, GameObject context) =>
        CellMenu.Entries.Single(entry => entry.Name == item).Create(new MenuCommand(context));

    GameObject Put(PackageAsset prefab)
    {
        var made = Keep(new GameObject(prefab.Name));
        Project.PutAs(prefab.Guid, prefab.Name + ".prefab", made);
        return made;
    }
}
