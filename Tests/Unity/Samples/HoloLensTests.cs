using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Tests.Anchoring;
using NUnit.Framework;
using TMPro;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests the effects of the buttons, sliders and voice commands of the sample.</summary>
public sealed class HoloLensTests
{
    PlayedHoloLens _sample;

    [SetUp]
    public void Begin() => _sample = new PlayedHoloLens();

    [TearDown]
    public void End() => _sample.Dispose();

    [Test]
    public void Menu_WithoutHand_IsHiddenAndIgnoresPresses()
    {
        _sample.Press("Ghost");

        Assert.That(_sample.Actions.IsGhostShown, Is.False);
        Assert.That(_sample.Child<Transform>("MenuContent-Canvas").gameObject.activeSelf, Is.False);
    }

    [Test]
    public void Menu_HandLost_IsHidden()
    {
        _sample.ShowTheHand();

        _sample.Child<HandConstraintPalmUp>("HandMenuBase").OnLastHandLost.Invoke();

        Assert.That(_sample.Child<Transform>("MenuContent-Canvas").gameObject.activeSelf, Is.False);
    }

    [TestCase("Connect")]
    [TestCase("Ghost")]
    [TestCase("Occlusion")]
    [TestCase("Panel")]
    public void Toggle_Pressed_RunsTheActionAndShowsTheState(string name)
    {
        _sample.ShowTheHand();
        _sample.Run();
        var before = _sample.IsOn(name);
        Assert.That(_sample.Child<PressableButton>(name).IsToggled.Active, Is.EqualTo(before), "the toggle shows the initial state");

        _sample.Press(name);

        Assert.That(_sample.IsOn(name), Is.EqualTo(!before));
        Assert.That(_sample.Child<PressableButton>(name).IsToggled.Active, Is.EqualTo(!before));
    }

    [Test]
    public void Sliders_Moved_ChangeNudgeAndOpacity()
    {
        _sample.ShowTheHand();
        _sample.Run();
        Assert.That((_sample.Actions.NudgeMs, _sample.Actions.Opacity), Is.EqualTo((0f, 1f)), "the events that sliders raise at their start have no effect");

        _sample.Child<Slider>("L_visu Nudge").Value = 8;
        _sample.Child<Slider>("Opacity").Value = 0.5f;
        _sample.Run();

        Assert.That(_sample.Session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(48).Within(1e-4));
        Assert.That(_sample.Actions.Opacity, Is.EqualTo(0.5f));
        Assert.That(_sample.Child<TextMesh>("L_visu Nudge Words").text, Is.EqualTo("L_visu +8.0 ms"));
        Assert.That(_sample.Child<TextMesh>("Opacity Words").text, Is.EqualTo("Gripper 50 %"));

        _sample.Press("No Nudge");
        Assert.That(_sample.Actions.NudgeMs, Is.Zero);
        Assert.That(_sample.Child<Slider>("L_visu Nudge").Value, Is.Zero);
    }

    /// <summary>The hand that carries the menu moves with the sliders, so a step must be wider than its tremor.</summary>
    [Test]
    public void NudgeSlider_Steps_AreOneMillisecond()
    {
        var slider = _sample.Child<Slider>("L_visu Nudge");

        Assert.That(slider.UseSliderStepDivisions);
        Assert.That((slider.MaxValue - slider.MinValue) / slider.SliderStepDivisions, Is.EqualTo(1));
    }

    [Test]
    public void LockBase_ButtonOrVoiceCommand_LocksTheBaseAgain([Values] bool said)
    {
        var anchor = _sample.Child<BaseAnchor>("Base Anchor");
        var seen = _sample.Session.gameObject.AddComponent<FakeMarkers>();
        seen.Clock = _sample.Cell.Clock;
        seen.Markers["a"] = RigidTransform.Identity;
        seen.Base = RigidTransform.FromXyzRpy(1, 0, -0.4, 0, 0, 1);
        _sample.Child<Camera>("Main Camera").transform.SetPositionAndRotation(new Vector3(0, 0.8f, 1), Quaternion.Euler(90, 0, 0));
        anchor.Use("", new[] { new BaseMarker("a", RigidTransform.Identity) });
        _sample.Run(4);
        Assert.That(anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        var states = new List<BaseAnchorState>();
        anchor.StateChanged += () => states.Add(anchor.State);
        _sample.ShowTheHand();

        if (said) Assert.That(_sample.Speech.Say("overlay lock base"), Is.True);
        else _sample.Press("Lock Base");
        _sample.Run(4);

        Assert.That(states.First(), Is.EqualTo(BaseAnchorState.Searching));
        Assert.That(states.Last(), Is.EqualTo(BaseAnchorState.Locked));
    }

    // A wearer who repeats a command because nothing seemed to happen must not undo it.
    [TestCase("Connect", "overlay connect", "overlay disconnect")]
    [TestCase("Ghost", "overlay ghost", "overlay hide ghost")]
    [TestCase("Occlusion", "overlay occlusion", "overlay no occlusion")]
    [TestCase("Panel", "overlay panel", "overlay hide panel")]
    public void VoiceCommand_MenuHidden_LeadsToTheStateThatItNames(string name, string on, string off)
    {
        foreach (var (keyword, isOn) in new[] { (on, true), (on, true), (off, false), (off, false), (on, true) })
        {
            Assert.That(_sample.Speech.Say(keyword), Is.True, keyword);
            _sample.Run();
            Assert.That(_sample.IsOn(name), Is.EqualTo(isOn), keyword);
        }
    }

    [Test]
    public void VoiceCommand_ForASlider_ChangesItsValueInSteps()
    {
        _sample.Speech.Say("overlay ahead");
        _sample.Speech.Say("overlay ahead");
        _sample.Speech.Say("overlay behind");
        _sample.Speech.Say("overlay fainter");
        _sample.Speech.Say("overlay fainter");
        _sample.Speech.Say("overlay stronger");
        _sample.Run();

        Assert.That(_sample.Actions.NudgeMs, Is.EqualTo(1));
        Assert.That(_sample.Actions.Opacity, Is.EqualTo(0.8f).Within(1e-6));
        Assert.That(_sample.Child<Slider>("L_visu Nudge").Value, Is.EqualTo(1));
    }

    [Test]
    public void VoiceCommand_ForTheCalibrationByEye_ShiftsTheRobotAndSetsMarks()
    {
        var nudge = _sample.Session.GetComponent<LatencyNudge>();

        foreach (var keyword in new[] { "overlay forward", "overlay forward", "overlay backward" })
            Assert.That(_sample.Speech.Say(keyword), Is.True, keyword);
        Assert.That((nudge.enabled, nudge.OffsetMm), Is.EqualTo((true, 1f)));

        foreach (var keyword in new[] { "overlay mark", "overlay apply" })
        {
            Assert.That(_sample.Speech.Say(keyword), Is.True, keyword);
            Assert.That(nudge.Problem, Is.Not.Null, "the robot does not move");
        }
        Assert.That((_sample.Speech.Say("overlay clear"), nudge.Problem), Is.EqualTo((true, (string)null)));
    }

    [Test]
    public void MovableObjects_Interaction_SupportsHandPinchAndRay()
    {
        var grasped = _sample.Roots.SelectMany(r => r.GetComponentsInChildren<ObjectManipulator>(true)).ToList();

        Assert.That(grasped.Select(g => g.name), Is.EquivalentTo(new[] { "Hand-Placed Marker", "Bar" }));
        foreach (var each in grasped)
        {
            Assert.That(each.AllowedInteractionTypes.HasFlag(InteractionFlags.Near | InteractionFlags.Ray | InteractionFlags.Gaze), each.name);
            Assert.That(each.AllowedManipulations, Is.EqualTo(TransformFlags.Move | TransformFlags.Rotate), each.name + " keeps its size");
            Assert.That(each.GetComponents<Component>().Any(c => c.GetType().Name == "OpaqueComponent"), each.name + " has a box to be hit");
        }
    }

    [Test]
    public void SampleButtons_All_HaveLabelsAndDoNotOverlap()
    {
        var buttons = _sample.Roots.SelectMany(r => r.GetComponentsInChildren<PressableButton>(true)).ToList();

        Assert.That(buttons, Is.Not.Empty);
        foreach (var button in buttons) Assert.That(LabelOf(button), Is.Not.EqualTo("Label").And.Not.EqualTo("Button"), button.name);
        foreach (var canvas in buttons.GroupBy(b => b.transform.parent))
            foreach (var (a, b) in canvas.SelectMany((a, i) => canvas.Skip(i + 1).Select(b => (a, b))))
                Assert.That(Apart(a.transform, b.transform), Is.GreaterThanOrEqualTo(32), a.name + " and " + b.name);
    }

    // MRTK3 shows the keyword beside the button that the wearer looks at. If a voice command had the same phrase, a toggle would switch twice.
    [Test]
    public void SampleButtons_All_HaveTheirLabelAsKeyword()
    {
        var buttons = _sample.Roots.SelectMany(r => r.GetComponentsInChildren<PressableButton>(true)).ToList();

        // The bar of the panel has symbols in place of words.
        foreach (var button in buttons.Where(button => button.SpeechRecognitionKeyword is not ("stay" or "close")))
            Assert.That(button.SpeechRecognitionKeyword, Is.EqualTo(LabelOf(button).ToLowerInvariant()), button.name);
        Assert.That(buttons.Select(button => button.SpeechRecognitionKeyword), Is.Unique.And.SupersetOf(new[] { "stay", "close" }));
        Assert.That(buttons.Where(button => !button.AllowSelectByVoice).Select(button => button.name), Is.EqualTo(new[] { "Accept" }));
        Assert.That(_sample.Speech.GetAllKeywords().Keys, Is.Not.Empty.And.All.StartsWith("overlay "));
    }

    static string LabelOf(PressableButton button) => button.GetComponentsInChildren<TextMeshProUGUI>(true)
        .Single(text => IsShownIn(button.transform, text.transform)).m_text;

    static bool IsShownIn(Transform root, Transform part)
    {
        for (var at = part; at != root; at = at.parent)
            if (!at.gameObject.activeSelf) return false;
        return true;
    }

    static float Apart(Transform a, Transform b)
    {
        var way = ((RectTransform)a)._anchoredPosition - ((RectTransform)b)._anchoredPosition;
        return Mathf.Max(Mathf.Abs(way.x), Mathf.Abs(way.y));
    }
}
