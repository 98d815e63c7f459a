using Nowpose.Editor.Setup;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>A project with a camera in the stand-in editor, and its review by the checks for HoloLens 2.</summary>
sealed class ReviewedProject
{
    public ReviewedProject(EditorFixture fixture)
    {
        OpenXrAssets.Put(fixture.Keep, BuildTargetGroup.WSA, BuildTargetGroup.Android);
        var player = fixture.Keep(ScriptableObject.CreateInstance<PlayerAssetOfATest>());
        player.activeInputHandler = 0;
        Project.Put("ProjectSettings/ProjectSettings.asset", player);
        Camera = fixture.Keep(new GameObject("Camera") { tag = "MainCamera" }).AddComponent<Camera>();
        Camera.nearClipPlane = 0.02f;
        Settings = new UnityProjectSettings(HeadsetPlatform.HoloLens2);
        Review = new ProjectReview(ProjectChecks.ForHoloLens(), Settings);
    }

    public UnityProjectSettings Settings { get; set; }
    public ProjectReview Review { get; set; }
    public Camera Camera { get; }

    /// <summary>Returns whether the fix of a check adds a package.</summary>
    public static bool AddsPackage(ProjectCheck check) => check.FixLabel?.StartsWith("Add ", StringComparison.Ordinal) == true;

    /// <summary>Returns whether the fix of a check changes a setting itself.</summary>
    public static bool ChangesSetting(ProjectCheck check) =>
        check.FixLabel != null && !AddsPackage(check) && check.FixLabel != "Open Project Settings";

    public int IndexOf(string title) => IndexIn(Review, title);

    public static int IndexIn(ProjectReview review, string title) => review.Checks.Select(c => c.Title).ToList().IndexOf(title);

    // Contains the field of ProjectSettings.asset that the checks read.
    sealed class PlayerAssetOfATest : ScriptableObject
    {
        public int activeInputHandler;
    }
}
