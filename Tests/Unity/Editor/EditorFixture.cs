using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Base class of tests with the stand-in editor. Resets the editor to a new project before each test.</summary>
public abstract class EditorFixture
{
    /// <summary>Objects to destroy after the test.</summary>
    protected List<Object> Made { get; } = new();

    [SetUp]
    public void ResetTheEditor()
    {
        GuiRecorder.Clear();
        PlayerSettings.Reset();
        EditorUserBuildSettings.Reset();
        Client.Reset();
        UnityEditor.PackageManager.PackageInfo.Registered.Clear();
        EditorApplication.MenuItems.Clear();
        EditorApplication.Now = 0;
        EditorApplication.delayCall = null;
        EditorUtility.Chosen = "";
        Undo.Clear();
        SessionState.Clear();
        PrefabUtility.Recorded.Clear();
        QualitySettings.renderPipeline = null;
        World.Current.Scenes.BuildList = default;
        Selection.activeObject = null;
        Project.Open(null);
    }

    [TearDown]
    public void DestroyWhatWasMade()
    {
        foreach (var made in Made.Where(o => o)) Object.DestroyImmediate(made, true);
        Made.Clear();
        Project.Open(null);
    }

    /// <summary>Registers an object, which is destroyed after the test.</summary>
    public T Keep<T>(T made) where T : Object
    {
        Made.Add(made);
        return made;
    }
}
