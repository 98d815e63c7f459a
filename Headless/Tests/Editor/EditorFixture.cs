using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Headless.Tests.Editor;

/// <summary>Each test finds the editor as it is in a new project.</summary>
public abstract class EditorFixture
{
    /// <summary>What is destroyed after the test.</summary>
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
        Undo.Clear();
        Selection.activeObject = null;
        Project.Open(null);
        // Unity's editor has loaded what the package depends on; .NET does so when it is used first.
        Assert.That(new[] { typeof(MathNet.Numerics.Constants), typeof(Newtonsoft.Json.JsonTextReader) }, Is.Not.Empty);
    }

    [TearDown]
    public void DestroyWhatWasMade()
    {
        foreach (var made in Made.Where(o => o)) Object.DestroyImmediate(made, true);
        Made.Clear();
        Project.Open(null);
    }

    protected T Keep<T>(T made) where T : Object
    {
        Made.Add(made);
        return made;
    }
}
