using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.PlayedAppearance;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests that parts are not drawn if they follow no robot because the rig or the gripper is missing, disabled or refused.</summary>
public class UnmovedPartsTests
{
    PlayedAppearance _played;

    [SetUp]
    public void Begin() => _played = new PlayedAppearance();

    [TearDown]
    public void End() => _played.Dispose();

    [Test]
    public void Show_RigCannotShowTheRobot_IsNotDrawn()
    {
        // An object with the name of the root link is sufficient for the rig to search for all links, which it does not find.
        Child("arm_link_0", _played.Rig.transform);

        _played.Play(5);

        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_played.Tool.isVisible, Is.False);
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.RigNotMoved));
    }

    [Test]
    public void Show_RigDisabled_IsNotDrawnUntilEnabled()
    {
        _played.BeCurrent();

        _played.Rig.enabled = false;
        _played.Run(0.1);
        Assert.That(_played.Tool.isVisible, Is.False);
        _played.Rig.enabled = true;
        _played.Run(0.1);

        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Label.text, Is.Empty);
    }

    [TestCase(false, false)]
    [TestCase(true, false)]
    [TestCase(false, true)]
    public void Show_RigDestroyed_ItsPartsAreNotDrawn(bool refreshed, bool enabledAgain)
    {
        _played.BeCurrent();
        var arm = _played.Rig.Link("arm_link_2").GetComponentInChildren<MeshRenderer>();
        Assert.That(arm.isVisible, Is.True);

        UnityEngine.Object.Destroy(_played.Rig);
        _played.Run(0.1);
        if (refreshed) _played.Appearance.Refresh();
        if (enabledAgain) _played.Appearance.enabled = false;
        if (enabledAgain) _played.Appearance.enabled = true;
        _played.Run(0.1);

        Assert.That(_played.Session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_played.Tool.isVisible, Is.False);
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.RigNotMoved));
    }

    [Test]
    public void Show_NoRig_DrawsAccordingToThePose()
    {
        var sign = Part("Sign", _played.Session.transform);
        sign.gameObject.AddComponent<PoseAppearance>();

        _played.BeCurrent();

        Assert.That(sign.isVisible, Is.True);
    }

    /// <summary>Creates a gripper with its own Pose Appearance that follows the rig but is not below it.</summary>
    (VirtualGripper Gripper, Renderer Part, TextMesh Words) MountElsewhere(string flange = "")
    {
        var gripper = Child("Gripper", _played.Session.transform).AddComponent<VirtualGripper>()
            .With("_rig", _played.Rig).With("_flangeLink", flange);
        var part = Part("Palm", gripper.transform);
        var words = Child("Gripper's Words", gripper.transform).AddComponent<TextMesh>();
        words.gameObject.AddComponent<MeshRenderer>();
        gripper.gameObject.AddComponent<PoseAppearance>().With("_words", words);
        return (gripper, part, words);
    }

    [Test]
    public void Show_GripperOnAnotherRig_DrawsAccordingToThePose()
    {
        var (_, part, words) = MountElsewhere();

        _played.BeCurrent();

        Assert.That(part.isVisible, Is.True);
        Assert.That(words.text, Is.Empty);
    }

    [TestCase("rig disabled")]
    [TestCase("rig destroyed")]
    [TestCase("rig refused")]
    [TestCase("flange unknown")]
    [TestCase("gripper disabled")]
    [TestCase("gripper destroyed")]
    public void Show_GripperCannotFollow_IsNotDrawn(string trouble)
    {
        if (trouble == "rig refused") Child("arm_link_0", _played.Rig.transform);
        var (gripper, part, words) = MountElsewhere(trouble == "flange unknown" ? "hand" : "");

        _played.BeCurrent();
        if (trouble == "rig disabled") _played.Rig.enabled = false;
        if (trouble == "rig destroyed") UnityEngine.Object.Destroy(_played.Rig);
        if (trouble == "gripper disabled") gripper.enabled = false;
        if (trouble == "gripper destroyed") UnityEngine.Object.Destroy(gripper);
        _played.Run(0.1);

        Assert.That(part.isVisible, Is.False);
        Assert.That(words.text, Is.EqualTo(PoseMessages.GripperNotMoved));
    }

    [Test]
    public void Show_GripperBelowTheRigIsDisabled_DrawsOnlyTheArm([Values] bool destroyed)
    {
        var gripper = Child("Gripper", _played.Rig.transform).AddComponent<VirtualGripper>();
        var part = Part("Palm", gripper.transform);
        _played.BeCurrent();
        Assert.That(part.isVisible, Is.True);

        if (destroyed) UnityEngine.Object.Destroy(gripper);
        else gripper.enabled = false;
        _played.Run(0.1);
        _played.Appearance.Refresh();

        Assert.That(part.isVisible, Is.False);
        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.GripperNotMoved));
    }

    [Test]
    public void Show_GripperObjectInactive_HasNoText()
    {
        var gripper = Child("Gripper", _played.Rig.transform).AddComponent<VirtualGripper>();
        _played.BeCurrent();

        gripper.gameObject.SetActive(false);
        _played.Run(0.1);

        Assert.That(_played.Label.text, Is.Empty);
    }
}
