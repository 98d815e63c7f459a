using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Runs the scenes in a player without connecting, because the ports of this machine may belong to other programs.</summary>
public sealed class PackageScenesTests
{
    static IEnumerable<string> Scenes => RepositoryFiles.All.Where(f => f.EndsWith(".unity", StringComparison.Ordinal));

    static IEnumerable<string> ScenesWithRobot => Scenes.Where(s => !s.Contains("Any Robot", StringComparison.Ordinal));

    [TestCaseSource(nameof(Scenes))]
    public void Scene_PlayedAlone_BindsItsRigWithoutWarnings(string path)
    {
        using var player = Play(path);

        for (var frame = 0; frame < 30; frame++) player.Step(frame / 60.0);

        Assert.That(player.Logs.Where(l => l.Type != LogType.Log).Select(l => l.Message).Where(m => !IsOfNoHeadset(m)), Is.Empty);
        var rig = player.Find<VirtualGripper>().Rig;
        Assert.That(rig.Shows, Is.EqualTo(RigPose.Displayed));
        Assert.That(rig.Model?.Name, Is.EqualTo(ScenesWithRobot.Contains(path) ? "youbot" : null), "no gateway describes any other");
        Assert.That(player.Find<Camera>().CompareTag("MainCamera"), Is.True);
        Assert.That(player.Find<StatusPanel>().transform.Find("Cells/Ground"), Is.Not.Null);
    }

    [TestCaseSource(nameof(ScenesWithRobot))]
    public void Scene_GhostShown_FollowsTheHeldPose(string path)
    {
        using var player = Play(path);
        var ghost = player.Find<BaseAnchor>().GetComponentInChildren<Ghost>(true);

        ghost.Visible = true;
        player.Step(0);
        player.Step(0.1);

        Assert.That(ghost.GapMetres, Is.EqualTo(0).Within(1e-6), "nothing has moved yet");
        Assert.That(ghost.GetComponentInChildren<VirtualGripper>().Rig, Is.SameAs(ghost.GetComponent<RobotRig>()));
    }

    /// <summary>Whether a message is AR Foundation's own warning about a missing headset, which the package does not suppress.</summary>
    static bool IsOfNoHeadset(string message) => message.StartsWith("No active ", StringComparison.Ordinal);

    static Player Play(string path)
    {
        var player = new Player(new AssetLibrary(RepositoryFiles.Root));
        player.LoadScene(path, roots =>
        {
            foreach (var session in roots.SelectMany(r => r.GetComponents<MrilSession>())) session.With("_connectOnEnable", false);
        });
        return player;
    }
}
