using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>
/// Tests the scenes in a player. The sessions do not connect, because other programs may use the ports of this machine. Their clock advances with the
/// frames, so that the simulated control systems produce the same samples on every machine.
/// </summary>
public sealed class PackageScenesTests
{
    SteppedClock _clock;

    [SetUp]
    public void CreateClock() => _clock = new SteppedClock();

    static IEnumerable<string> Scenes => RepositoryFiles.All.Where(f => f.EndsWith(".unity", StringComparison.Ordinal));

    static IEnumerable<string> ScenesWithRobot => Scenes.Where(s => !s.Contains("Any Robot", StringComparison.Ordinal));

    [TestCaseSource(nameof(Scenes))]
    public void Scene_PlayedAlone_BindsItsRigWithoutWarnings(string path)
    {
        using var player = Play(path);

        for (var frame = 0; frame < 30; frame++) Step(player, frame / 60.0);

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
        Step(player, 0);
        Step(player, 0.1);

        Assert.That(ghost.GapMetres, Is.EqualTo(0).Within(1e-6), "nothing has moved yet");
        Assert.That(ghost.GetComponentInChildren<VirtualGripper>().Rig, Is.SameAs(ghost.GetComponent<RobotRig>()));
    }

    /// <summary>Returns whether a message is a warning of AR Foundation about a missing headset. The package does not suppress it.</summary>
    static bool IsOfNoHeadset(string message) => message.StartsWith("No active ", StringComparison.Ordinal);

    void Step(Player player, double seconds)
    {
        _clock.Set(100 + seconds);
        player.Step(seconds);
    }

    Player Play(string path)
    {
        var player = new Player(RepositoryAssets.NewLibrary());
        player.LoadScene(path, roots =>
        {
            foreach (var session in roots.SelectMany(r => r.GetComponents<MrilSession>()))
                session.With("_connectOnEnable", false).HeadsetClock = _clock;
        });
        return player;
    }
}
