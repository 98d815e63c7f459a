using Nowpose.Editor;
using Nowpose.Editor.Messages;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the button of a tracked object's inspector that adds a ghost.</summary>
public sealed class ObjectGhostTests : EditorFixture
{
    [Test]
    public void AddGhost_ButtonClicked_AddsTheMeshesInTheGhostMaterialWithUndo()
    {
        var material = Keep(new Material((Shader)null));
        Project.PutAs(PackageAsset.Ghost.Guid, "Ghost.mat", material);
        var session = Keep(new GameObject("cell")).AddComponent<MrilSession>();
        var anchor = Below("Base Anchor", session.transform);
        var box = Below("box", anchor).gameObject.AddComponent<TrackedObject>().With("_session", session);
        box.transform.localPosition = new Vector3(1, 2, 3);
        var mesh = Drawn(Below("lid", box.transform));
        box.transform.Find("lid").localScale = Vector3.one * 0.001f;
        Drawn(Below("on it", box.transform));
        box.transform.Find("on it").gameObject.AddComponent<TrackedObject>();
        Below("label", box.transform).gameObject.AddComponent<TextMesh>();

        Click(box);

        var ghost = ((GameObject)Selection.activeObject).GetComponent<TrackedObject>();
        Assert.That((ghost.name, ghost.Frame, ghost.Shows, ghost.transform.parent), Is.EqualTo(("ghost of box", "box", RigPose.Held, anchor)));
        Assert.That(ghost.IsOf(session));
        Assert.That(ghost.transform.localPosition, Is.EqualTo(new Vector3(1, 2, 3)));
        var drawn = ghost.GetComponentsInChildren<Renderer>(true).Single();
        Assert.That((drawn.name, drawn.transform.localScale), Is.EqualTo(("lid", Vector3.one * 0.001f)));
        Assert.That(drawn.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(mesh));
        Assert.That(drawn.sharedMaterials, Is.EqualTo(new[] { material, material }));
        Assert.That(Undo.Created, Is.EqualTo(new[] { ghost.gameObject }));
    }

    [Test]
    public void AddGhost_ObjectIsAGhost_HasNoButton()
    {
        var ghost = Keep(new GameObject("ghost")).AddComponent<TrackedObject>().With("_shows", RigPose.Held);

        Keep(UnityEditor.Editor.CreateEditor(ghost)).OnInspectorGUI();

        Assert.That(GuiRecorder.Buttons, Does.Not.Contain(InspectorTexts.AddGhost));
    }

    static Transform Below(string name, Transform parent)
    {
        var made = new GameObject(name).transform;
        made.SetParent(parent);
        return made;
    }

    Mesh Drawn(Transform at)
    {
        var mesh = Keep(new Mesh());
        at.gameObject.AddComponent<MeshFilter>().sharedMesh = mesh;
        at.gameObject.AddComponent<MeshRenderer>().sharedMaterials = new Material[2];
        return mesh;
    }

    void Click(TrackedObject box)
    {
        var editor = Keep(UnityEditor.Editor.CreateEditor(box));
        GuiRecorder.Click = InspectorTexts.AddGhost;
        editor.OnInspectorGUI();
        Assert.That(GuiRecorder.Click, Is.Null, "no such button");
    }
}
