using Nowpose.Editor.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the check of the build list with the settings of the stand-in editor.</summary>
public sealed class FirstSceneTests : EditorFixture
{
    // A scene that is not in the list has the index -1 or the length of the list.
    [TestCase("Good", -1, 0)]
    [TestCase("Good", 0, 1)]
    [TestCase("Good", 0, 2)]
    [TestCase("Advice", 1, 2)]
    [TestCase("Advice", -1, 1)]
    [TestCase("Advice", 1, 1)]
    public void FirstScene_BuildList_AdvisesUnlessItStartsWithTheOpenScene(string state, int index, int count)
    {
        var reviewed = new ReviewedProject(this);
        World.Current.Scenes.BuildList = (index, count);
        reviewed.Review.Refresh();

        Assert.That(reviewed.Review.Results[reviewed.IndexOf(CheckTitles.FirstScene)].State.ToString(), Is.EqualTo(state));
    }
}
