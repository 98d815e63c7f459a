using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Unity;

public class FrameAllocationTests
{
    [TestCase(false)]
    [TestCase(true)]
    public void Frame_WarmWithEverythingShown_AllocatesNothing(bool rewrites)
    {
        using var cell = new PlayedCell();
        var session = cell.NewSession();
        session.With("_settings", ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_rewriteBeforeRender", rewrites));
        var anchor = Below<BaseAnchor>(session.transform);
        var rig = Below<RobotRig>(anchor.transform);
        var gripper = Below<VirtualGripper>(rig.transform);
        gripper.With("_fingers", new List<GripperFinger> { new("gripper_finger_joint_l", Below<FrameProbe>(gripper.transform).transform) });
        var ghost = Below<Ghost>(anchor.transform);
        ghost.GetComponent<RobotRig>().With("_shows", RigPose.Held);
        session.gameObject.SetActive(true);
        cell.Run(10, session);

        var (shown, gap, samples) = (0, 0f, 0L);
        session.Shown += _ => shown++;
        cell.Allocated = 0;
        cell.Run(10, session, () =>
        {
            gap = Math.Max(gap, ghost.GapMetres ?? 0);
            samples = session.Statistics.Samples;
        });

        Assert.That(cell.Allocated, Is.EqualTo(0));
        Assert.That(shown, Is.EqualTo(rewrites ? 1200 : 600).Within(2));
        Assert.That(gap, Is.GreaterThan(0));
        Assert.That(samples, Is.GreaterThan(350));
    }

    static T Below<T>(Transform parent) where T : Component
    {
        var made = new GameObject(typeof(T).Name);
        made.transform.SetParent(parent, false);
        return made.AddComponent<T>();
    }
}
