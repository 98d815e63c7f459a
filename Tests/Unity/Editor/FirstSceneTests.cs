using Nowpose.Editor.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the check of the build list with the settings of the stand-in editor.</summary>
public sealed class FirstSceneTests : EditorFixture
{
    // The path of the open scene is empty here.
    [TestCase("Good")]
    [TestCase("Good", "")]
    [TestCase("Good", "", "Assets/Scenes/SampleScene.unity")]
    [TestCase("Advice", "Assets/Scenes/SampleScene.unity", "")]
    [TestCase("Advice", "Assets/Scenes/SampleScene.unity")]
    public void FirstScene_BuildList_AdvisesUnlessItStartsWithTheOpenScene(string state, params string[] list)
    {
        var reviewed = new ReviewedProject(this);
        World.Current.Scenes.BuildList.AddRange(list);
        reviewed.Review.Refresh();

        Assert.That(reviewed.Review.Results[reviewed.IndexOf(CheckTitles.FirstScene)].State.ToString(), Is.EqualTo(state));
    }
}
