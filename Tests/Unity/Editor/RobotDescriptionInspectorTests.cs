using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

public sealed class RobotDescriptionInspectorTests : EditorFixture
{
    const string LoadLabel = InspectorTexts.LoadUrdf;

    static readonly string Robot =
        "<robot name='two'><link name='a'/><link name='b'/><joint name='elbow' type='revolute'><parent link='a'/><child link='b'/>"
        + "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>";

    [Test]
    public void Draw_ValidRobot_ShowsItsProperties()
    {
        Draw(Inspect(Robot));

        Assert.That(GuiRecorder.Texts, Does.Contain("Robot: two"));
        Assert.That(GuiRecorder.Texts, Does.Contain(InspectorTexts.MovingJoints + ": elbow"));
        Assert.That(GuiRecorder.Texts, Does.Contain("Characters: " + Robot.Length));
        Assert.That(GuiRecorder.Texts, Does.Contain("SHA-256: " + Nowpose.Kinematics.UrdfHash.Of(Robot)));
        Assert.That(GuiRecorder.Properties, Is.Empty, "a text field of the Inspector does not hold a whole URDF");
    }

    [Test]
    public void Draw_InvalidRobot_ShowsTheReason()
    {
        Draw(Inspect("<robot name='x'>"));

        Assert.That(GuiRecorder.Texts.Count(t => t.StartsWith("'Mine':", StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(GuiRecorder.Texts, Does.Contain("Robot: –"));
    }

    [Test]
    public void Draw_NoUrdf_ShowsTheRemedy()
    {
        Draw(Inspect(""));

        Assert.That(GuiRecorder.Texts, Does.Contain(RigMessages.NoUrdf("Mine")));
        Assert.That(GuiRecorder.Texts, Does.Contain("SHA-256: –"));
    }

    [Test]
    public void Draw_LongText_ShowsOnlyItsBeginning()
    {
        var text = new string('x', 200) + "\n" + string.Concat(Enumerable.Range(2, 100).Select(i => "line " + i + "\n"));

        Draw(Inspect(text));

        var shown = GuiRecorder.Texts[^1].Split('\n');
        Assert.That(shown[0], Is.EqualTo(new string('x', 120) + "…"));
        Assert.That(shown[11], Is.EqualTo("line 12"));
        Assert.That(shown[12], Is.EqualTo("…"));
        Assert.That(GuiRecorder.Texts.Max(t => t.Length), Is.LessThan(2000));
    }

    [Test]
    public void Load_FileChosen_SetsTheTextWithUndo()
    {
        using var folder = new ProjectFolder();
        folder.Write("two.urdf", Robot);
        var editor = Inspect("");
        var asset = (RobotDescriptionAsset)editor.target;
        Draw(editor);
        EditorUtility.Chosen = Path.Combine(folder.Root, "two.urdf");

        Click(editor);

        Assert.That(asset.Urdf, Is.EqualTo(Robot));
        Draw(editor);
        Assert.That(GuiRecorder.Texts, Does.Contain("Robot: two"));
        Assert.That(Undo.Steps, Has.Count.EqualTo(1));
    }

    [Test]
    public void Load_DialogCancelled_ChangesNothing()
    {
        var editor = Inspect(Robot);

        Click(editor);

        Assert.That(((RobotDescriptionAsset)editor.target).Urdf, Is.EqualTo(Robot));
    }

    [Test]
    public void Load_AssetDeletedBeforeTheDialog_DoesNotThrow()
    {
        var editor = Inspect(Robot);
        GuiRecorder.Click = LoadLabel;
        editor.OnInspectorGUI();
        UnityEngine.Object.DestroyImmediate(editor.target, true);

        Assert.That(EditorApplication.RunDelayed, Throws.Nothing);
    }

    static void Click(UnityEditor.Editor editor)
    {
        GuiRecorder.Click = LoadLabel;
        editor.OnInspectorGUI();
        EditorApplication.RunDelayed();
    }

    static void Draw(UnityEditor.Editor editor)
    {
        GuiRecorder.Clear();
        editor.OnInspectorGUI();
    }

    UnityEditor.Editor Inspect(string urdf)
    {
        var editor = Keep(UnityEditor.Editor.CreateEditor(Keep(RobotDescriptionAsset.Create("Mine", urdf))));
        Assert.That(editor, Is.InstanceOf<RobotDescriptionAssetEditor>());
        return editor;
    }
}
