using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Tests objects of the cell in a running scene: tracked, placed by hand, and gripped.</summary>
public class PlayedObjectTests : PlayedParts
{
    [Test]
    public void TrackedObject_Moving_IsShownAtTheDisplayTimeRelativeToTheAnchor()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        anchor.transform.position = new Vector3(1, 2, 3);
        var box = Below<TrackedObject>("box", anchor.transform);
        Run(2, t => SendPose("world", "box", t, Along(0.3 * t, 0.4 * t)));

        Run(1, t => SendPose("world", "box", t, Along(0.3 * t, 0.4 * t)), () =>
        {
            Assert.That(box.State, Is.EqualTo(PoseState.Current));
            AssertAt(box.transform, anchor.transform, Along(0.3 * (_cell.Now + Visu), 0.4 * (_cell.Now + Visu)), 1e-3);
        });
        anchor.transform.position = new Vector3(-5, 0, 0);
        _cell.Frame(_session);

        AssertAt(box.transform, anchor.transform, Along(0.3 * (_cell.Now + Visu), 0.4 * (_cell.Now + Visu)), 1e-3);
    }

    // Objects and rigs elsewhere in the hierarchy follow the anchor, but are not destroyed with it.
    [Test]
    public void CellParts_BaseAnchorDestroyed_AreHeldWithTheReason()
    {
        var anchor = Below<BaseAnchor>("Base Anchor", _session.transform);
        var box = Loose<TrackedObject>("box");
        box.Follow(_session);
        var rig = Second(RobotFiles.LoadText("youbot"));
        var joints = RobotFiles.Load("youbot").MovingJoints.Select(joint => joint.Name).ToArray();
        void Send(double t)
        {
            _session.Session.Listener.Received(
                new JointStateMessage(At(t), joints, [.. joints.Select(_ => 0.003)]), HeadsetTime.FromSeconds(1000 + t + Latency), "arm2");
            SendPose("world", "arm2/arm_link_0", t, Along(1));
            SendPose("world", "box", t, Along(0.1 * t));
        }
        Run(2, Send);
        Assert.That((box.State, rig.StateIn(_session.Frame), FaultsNow()), Is.EqualTo((PoseState.Current, PoseState.Current, "")));

        UnityEngine.Object.Destroy(anchor.gameObject);
        Run(1, Send);

        Assert.That((box.State, rig.StateIn(_session.Frame)), Is.EqualTo((PoseState.Held, PoseState.Held)));
        Assert.That(box.GetComponent<PoseAppearance>().Look.Label, Is.EqualTo(PoseMessages.Of(PoseState.Held)));
        Assert.That(FaultsNow(), Is.EqualTo($"object box: {BaseMessages.Destroyed}; {RobotMessages.OfRobot("arm2", BaseMessages.Destroyed)}"));
        Assert.That(_cell.Player.Logs.Where(log => log.Exception != null), Is.Empty);
        box.enabled = false;
        box.enabled = true;
        Run(0.5, Send);
        Assert.That(box.State, Is.EqualTo(PoseState.Current), "relative to the session");
    }

    [Test]
    public void TrackedObject_ParentIsALink_MovesWithTheDisplayedGripper()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var part = Below<TrackedObject>("part", _session.transform);
        Run(1, t => SendPose("tool_centre_point", "part", t, Along(0.05)));

        Run(1, t => SendPose("tool_centre_point", "part", t, Along(0.05)), () =>
        {
            var grasp = UnityPoses.ToWorld(Along(0.05));
            Assert.That(Vector3.Distance(part.transform.position, rig.Tool.TransformPoint(grasp.position)), Is.LessThan(1e-4), "0.1 mm");
        });
        Assert.That(part.Parent, Is.EqualTo("tool_centre_point"));
    }

    // The objects below a moving one are enabled before it, as an inactive parent or a later change of the hierarchy causes it.
    [Test]
    public void TrackedObject_BelowAMovingObjectThatIsEnabledLater_IsNotDisplacedByIt()
    {
        var lid = Below<TrackedObject>("lid", _session.transform);
        var knob = Below<TrackedObject>("knob", lid.transform);
        var box = Below<TrackedObject>("box", _session.transform);
        var rig = Below<RobotRig>("Robot", _session.transform);
        void Send(double t)
        {
            SendPose("world", "box", t, Along(t));
            SendPose("world", "lid", t, Along(-t));
            SendPose("world", "knob", t, Along(0.5));
        }
        Run(2, Send, () => { if (lid.transform.parent == _session.transform && rig.Tool != null) lid.transform.SetParent(box.transform); });
        knob.enabled = false;
        knob.enabled = true;

        Run(1, Send, () =>
        {
            AssertAt(box.transform, _session.transform, Along(_cell.Now + Visu), 1e-3);
            AssertAt(lid.transform, _session.transform, Along(-_cell.Now - Visu), 1e-3);
            AssertAt(knob.transform, _session.transform, Along(0.5), 1e-3);
        });

        knob.transform.SetParent(rig.Tool);
        Run(1, Send, () => AssertAt(knob.transform, _session.transform, Along(0.5), 1e-3));
    }

    [Test]
    public void TrackedObject_NoLongerSent_LooksHeldWhileTheRobotIsCurrent()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        var appearance = box.GetComponent<PoseAppearance>();
        Run(2, t => SendPose("world", "box", t, Along(t)));
        Assert.That(appearance.Look.IsHatched, Is.False);

        Run(1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(box.State, Is.EqualTo(PoseState.Held));
        Assert.That(appearance.Look.IsHatched, Is.True);
    }

    [Test]
    public void Cell_WithoutARobot_ShowsObjectsAndSignals()
    {
        _session.RobotAsset = null;
        var rig = Below<RobotRig>("Robot", _session.transform);
        var box = Below<TrackedObject>("box", _session.transform);
        var jaw = Below<ActuatedPart>("jaw", _session.transform).With("_wayMetres", new Vector3(0, 0, 0.02f));
        Run(1, t => SendPose("world", "box", t, Along(t)));
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(1, t => SendPose("world", "box", t, Along(t)), () => AssertAt(box.transform, _session.transform, Along(_cell.Now + Visu), 1e-3));

        Assert.That((_session.Robot, _session.Frame, rig.Model), Is.EqualTo(((RobotModel)null, (DisplayFrame)null, (RobotModel)null)));
        Assert.That((box.State, box.GetComponent<PoseAppearance>().Look.IsHatched), Is.EqualTo((PoseState.Current, false)));
        Assert.That((jaw.Share, jaw.Fault), Is.EqualTo((1f, (string)null)));
    }

    [Test]
    public void TrackedObject_NeverSent_IsNotDrawn()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        Run(1);

        Assert.That((box.State, box.GapMetres), Is.EqualTo((PoseState.Incomplete, (float?)null)));
        Assert.That(box.GetComponent<PoseAppearance>().Look.IsDrawn, Is.False);
    }

    [Test]
    public void TrackedObject_ShowsHeldPose_IsAtTheNewestPoseAndNotListed()
    {
        var ghost = Below<TrackedObject>("ghost", _session.transform).With("_frame", "box").With("_shows", RigPose.Held);
        Run(2, t => SendPose("world", "box", t, Along(0.3 * t)));

        Run(1, t => SendPose("world", "box", t, Along(0.3 * t)), () =>
        {
            Assert.That(ghost.State, Is.EqualTo(PoseState.Current));
            // The pose that was sent in the previous frame arrived after that frame, so it is the newest pose.
            AssertAt(ghost.transform, _session.transform, Along(0.3 * (_cell.Now - 1 / 60.0 - Latency)), 1e-4);
            Assert.That(ghost.GapMetres, Is.EqualTo(0.3 * (Visu + 1 / 60.0 + Latency)).Within(1e-3));
        });
        Assert.That((_session.Parts.Count, _session.Parts.Grippable.Count), Is.EqualTo((0, 0)));
    }
}
