using Nowpose.Headless.Tests.Repository;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Unity.Assets;

/// <summary>The scenes as a player runs them, with no gateway to be found.</summary>
public sealed class PackageScenesTests
{
    static IEnumerable<string> Scenes => RepositoryFiles.All.Where(f => f.EndsWith(".unity", StringComparison.Ordinal));

    [TestCaseSource(nameof(Scenes))]
    public void Scene_Played_BindsItsRigsAndComplainsOfNothing(string path)
    {
        using var player = new Player(new AssetLibrary(RepositoryFiles.Root));
        player.LoadScene(path);

        for (var frame = 0; frame < 30; frame++) player.Step(frame / 60.0);

        Assert.That(player.Logs.Where(l => l.Type != LogType.Log).Select(l => l.Message), Is.Empty);
        var rig = player.Find<VirtualGripper>().Rig;
        Assert.That((rig.Model.Name, rig.Shows), Is.EqualTo(("youbot", RigPose.Displayed)));
        Assert.That(rig.Tool.IsChildOf(player.Find<BaseAnchor>().transform), Is.True, "the rig is the prefab's own");
        Assert.That(player.Find<Camera>().CompareTag("MainCamera"), Is.True);
    }

    [TestCaseSource(nameof(Scenes))]
    public void Scene_GhostShown_RidesOnTheHeldPose(string path)
    {
        using var player = new Player(new AssetLibrary(RepositoryFiles.Root));
        player.LoadScene(path);
        var ghost = player.Find<BaseAnchor>().GetComponentInChildren<Ghost>(true);

        ghost.Visible = true;
        player.Step(0);
        player.Step(0.1);

        Assert.That(ghost.GapMetres, Is.EqualTo(0).Within(1e-6), "nothing has moved yet");
        Assert.That(ghost.GetComponentInChildren<VirtualGripper>().Rig, Is.SameAs(ghost.GetComponent<RobotRig>()));
    }
}
