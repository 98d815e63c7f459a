using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

public sealed class OcclusionTests
{
    PlayedCell _cell;
    MrilSession _session;
    CellActions _actions;

    [SetUp]
    public void Begin()
    {
        Begin("Nowpose Robot Cell");
        Run(1);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Begin(string prefab)
    {
        _cell = new PlayedCell();
        _session = _cell.NewSessionOf(prefab);
        _actions = _session.gameObject.AddComponent<CellActions>();
        _session.gameObject.SetActive(true);
    }

    void Run(double seconds) => _cell.Run(seconds, _session);

    T Find<T>(string name) where T : Component => _session.GetComponentsInChildren<T>(true).First(c => c.name == name);

    IEnumerable<MeshRenderer> Occluders => OccludersOf(Find<RobotRig>("Robot"));

    static IEnumerable<MeshRenderer> OccludersOf(RobotRig rig) => rig.GetComponentsInChildren<MeshRenderer>(true)
        .Where(r => r.sharedMaterial != null && r.sharedMaterial.name == "Occluder");

    [Test]
    public void SetOcclusion_OffAndOn_HidesAndRestoresOnlyTheOccluders()
    {
        var gripper = Find<Transform>("Palm").GetComponentInChildren<MeshRenderer>();
        Assert.That(Occluders, Is.Not.Empty);

        _actions.SetOcclusion(false);
        Run(0.1);
        var off = Occluders.Count(r => r.isVisible);
        var gripperVisible = gripper.isVisible;
        _actions.SetOcclusion(true);
        Run(0.1);

        Assert.That(off, Is.Zero);
        Assert.That(gripperVisible, Is.True);
        Assert.That(Occluders.All(r => r.isVisible), Is.True);
    }

    [Test]
    public void SetOcclusion_OffBeforeTheRobotIsBuilt_HidesItsOccluders()
    {
        _cell.Dispose();
        Begin("Nowpose Robot Cell (Any Robot)");

        _actions.SetOcclusion(false);
        Run(1);

        Assert.That(Occluders, Is.Not.Empty);
        Assert.That(Occluders.Count(r => r.enabled), Is.Zero);
    }

    [Test]
    public void SetOcclusion_ComponentDisabled_RestoresTheOccluders()
    {
        _actions.SetOcclusion(false);

        _actions.enabled = false;

        Assert.That(Occluders.All(r => r.enabled), Is.True);
    }

    [Test]
    public void SetOcclusion_RobotAddedLater_HidesAndRestoresItsOccluders()
    {
        var added = UnityEngine.Object.Instantiate(Find<RobotRig>("Robot"), _session.transform);
        Run(0.1);

        _actions.SetOcclusion(false);
        var off = OccludersOf(added).Count(r => r.enabled);
        _actions.SetOcclusion(true);

        Assert.That(OccludersOf(added), Is.Not.Empty.And.All.Matches<MeshRenderer>(r => r.enabled));
        Assert.That(off, Is.Zero);
    }

    [Test]
    public void ToggleOcclusion_OccluderThatTheUserDisabled_StaysDisabled()
    {
        var own = Occluders.First();
        own.enabled = false;

        _actions.ToggleOcclusion();
        var off = (_actions.IsOcclusionOn, Occluders.Count(r => r.enabled));
        _actions.ToggleOcclusion();

        Assert.That(off, Is.EqualTo((false, 0)));
        Assert.That((_actions.IsOcclusionOn, Occluders.Count(r => !r.enabled), own.enabled), Is.EqualTo((true, 1, false)));
    }
}
