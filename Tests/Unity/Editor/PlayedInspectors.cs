using Nowpose.Unity;
using Nowpose.Unity.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Opens inspectors of components in a running cell. Dispose closes them.</summary>
sealed class PlayedInspectors : IDisposable
{
    // Files that one test saves must not change another one.
    readonly string _folder = Directory.CreateTempSubdirectory("nowpose-inspector-").FullName;

    public PlayedInspectors()
    {
        Cell = new PlayedCell();
        Cell.Player.World.Host.PersistentDataPath = _folder;
    }

    public PlayedCell Cell { get; }
    public List<UnityEditor.Editor> Editors { get; } = new();

    public UnityEditor.Editor Inspect(params Component[] components)
    {
        var editor = UnityEditor.Editor.CreateEditor(components);
        Editors.Add(editor);
        return editor;
    }

    public void Play(MrilSession session, double seconds) => Cell.Run(seconds, session, () =>
    {
        EditorApplication.Now = Cell.Now;
        EditorApplication.update?.Invoke();
    });

    public static VirtualGripper Gripper(RobotRig rig, params string[] joints)
    {
        var gripper = new GameObject("Gripper");
        gripper.transform.SetParent(rig.transform);
        var fingers = joints.Select(joint => new GripperFinger(joint, new GameObject("Finger").transform)).ToList();
        foreach (var finger in fingers) finger.Finger.SetParent(gripper.transform);
        return gripper.AddComponent<VirtualGripper>().With("_fingers", fingers);
    }

    public static T Below<T>(MrilSession session) where T : Component
    {
        var child = new GameObject(typeof(T).Name);
        child.transform.SetParent(session.transform);
        return child.AddComponent<T>();
    }

    public void Dispose()
    {
        foreach (var editor in Editors) UnityEngine.Object.DestroyImmediate(editor);
        Editors.Clear();
        Cell.Dispose();
        Directory.Delete(_folder, recursive: true);
        Assert.That(EditorApplication.update, Is.Null, "a closed inspector has unregistered its callback");
    }
}
