using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Tests.Anchoring;
using Nowpose.Unity.Tests.Mrtk3;
using Nowpose.Unity.Tests.Pairing;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using TMPro;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Runs the scene as a user imports it: buttons, sliders, voice commands and grasping have the stated effects.</summary>
public sealed class HoloLensTests
{
    const string ScenePath = "Packages/com.nowpose.mril/Samples~/HoloLens 2 (MRTK3)/HoloLens 2 (MRTK3).unity";

    PlayedCell _cell;
    MrilSession _session;
    CellActions _actions;
    SpokenKeywords _speech;
    IReadOnlyList<GameObject> _roots;
    string _folder;

    [SetUp]
    public void Begin()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-hololens-").FullName;
        _cell = new PlayedCell(new AssetLibrary(RepositoryFiles.Root));
        _cell.Player.World.Host.PersistentDataPath = _folder;
        _speech = new SpokenKeywords();
        XRSubsystemHelpers.Provide(_speech);
        _cell.Player.LoadScene(ScenePath, roots => _roots = roots);
        _session = _cell.Player.Find<MrilSession>();
        _session.HeadsetClock = _cell.Clock;
        _session.Settings = PlayedCell.Offline;
        _actions = _cell.Player.Find<CellActions>();
        Run(5);
    }

    [TearDown]
    public void End()
    {
        XRSubsystemHelpers.Provide(null);
        _cell.Dispose();
        Directory.Delete(_folder, true);
    }

    void Run(double seconds = 0.1) => _cell.Run(seconds, _session);

    T Child<T>(string name) where T : Component =>
        _roots.SelectMany(r => r.GetComponentsInChildren<T>(true)).Single(c => c.name == name);

    void ShowTheHand() => Child<HandConstraintPalmUp>("HandMenuBase").OnFirstHandDetected.Invoke();

    void Press(string name)
    {
        var button = Child<PressableButton>(name);
        button.Enter();
        button.Exit();
        Run();
    }

    [Test]
    public void Menu_WithoutHand_IsHiddenAndIgnoresPresses()
    {
        Press("Ghost");

        Assert.That(_actions.IsGhostShown, Is.False);
        Assert.That(Child<Transform>("MenuContent-Canvas").gameObject.activeSelf, Is.False);
    }

    [Test]
    public void Menu_HandLost_IsHidden()
    {
        ShowTheHand();

        Child<HandConstraintPalmUp>("HandMenuBase").OnLastHandLost.Invoke();

        Assert.That(Child<Transform>("MenuContent-Canvas").gameObject.activeSelf, Is.False);
    }

    [TestCase("Connect")]
    [TestCase("Ghost")]
    [TestCase("Occlusion")]
    [TestCase("Panel")]
    public void Toggle_Pressed_ActsAndShowsTheState(string name)
    {
        ShowTheHand();
        Run();
        var before = IsOn(name);
        Assert.That(Child<PressableButton>(name).IsToggled.Active, Is.EqualTo(before), "as it is from the start");

        Press(name);

        Assert.That(IsOn(name), Is.EqualTo(!before));
        Assert.That(Child<PressableButton>(name).IsToggled.Active, Is.EqualTo(!before));
    }

    bool IsOn(string name) => name switch
    {
        "Connect" => _session.IsConnecting,
        "Ghost" => Child<Ghost>("Ghost").Visible,
        "Occlusion" => _actions.IsOcclusionOn,
        _ => Child<StatusPanel>("Status Panel (MRTK3)").gameObject.activeSelf,
    };

    [Test]
    public void Sliders_Moved_NudgeAndFade()
    {
        ShowTheHand();
        Run();
        Assert.That((_actions.NudgeMs, _actions.Opacity), Is.EqualTo((0f, 1f)), "what sliders tell when they start changes nothing");

        Child<Slider>("L_visu Nudge").Value = 8;
        Child<Slider>("Opacity").Value = 0.5f;
        Run();

        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(48).Within(1e-4));
        Assert.That(_actions.Opacity, Is.EqualTo(0.5f));
        Assert.That(Child<TextMesh>("L_visu Nudge Words").text, Is.EqualTo("L_visu +8.0 ms"));
        Assert.That(Child<TextMesh>("Opacity Words").text, Is.EqualTo("Gripper 50 %"));

        Press("No Nudge");
        Assert.That(_actions.NudgeMs, Is.Zero);
        Assert.That(Child<Slider>("L_visu Nudge").Value, Is.Zero);
    }

    [Test]
    public void LockBase_PressedOrSpoken_LocksByTheMarkersAgain([Values] bool said)
    {
        var anchor = Child<BaseAnchor>("Base Anchor");
        var seen = _session.gameObject.AddComponent<FakeMarkers>();
        seen.Clock = _cell.Clock;
        seen.Markers["a"] = RigidTransform.Identity;
        seen.Base = RigidTransform.FromXyzRpy(1, 0, -0.4, 0, 0, 1);
        Child<Camera>("Main Camera").transform.SetPositionAndRotation(new Vector3(0, 0.8f, 1), Quaternion.Euler(90, 0, 0));
        anchor.Use("", new[] { new BaseMarker("a", RigidTransform.Identity) });
        Run(4);
        Assert.That(anchor.State, Is.EqualTo(BaseAnchorState.Locked));
        var states = new List<BaseAnchorState>();
        anchor.StateChanged += () => states.Add(anchor.State);
        ShowTheHand();

        if (said) Assert.That(_speech.Say("overlay lock base"), Is.True);
        else Press("Lock Base");
        Run(4);

        Assert.That(states.First(), Is.EqualTo(BaseAnchorState.Searching));
        Assert.That(states.Last(), Is.EqualTo(BaseAnchorState.Locked));
    }

    [TestCase("overlay connect")]
    [TestCase("overlay ghost")]
    [TestCase("overlay occlusion")]
    [TestCase("overlay panel")]
    public void Voice_MenuHidden_TriggersTheSameActions(string keyword)
    {
        var name = char.ToUpperInvariant(keyword[8]) + keyword.Substring(9);
        var before = IsOn(name);

        Assert.That(_speech.Say(keyword), Is.True);
        Run();

        Assert.That(IsOn(name), Is.EqualTo(!before));
    }

    [Test]
    public void Voice_MoreOrLess_ChangesTheSlidersInSteps()
    {
        _speech.Say("overlay ahead");
        _speech.Say("overlay ahead");
        _speech.Say("overlay behind");
        _speech.Say("overlay fainter");
        _speech.Say("overlay fainter");
        _speech.Say("overlay stronger");
        Run();

        Assert.That(_actions.NudgeMs, Is.EqualTo(1));
        Assert.That(_actions.Opacity, Is.EqualTo(0.8f).Within(1e-6));
        Assert.That(Child<Slider>("L_visu Nudge").Value, Is.EqualTo(1));
    }

    void Grasp(string name, Action<Transform> move)
    {
        var held = Child<ObjectManipulator>(name);
        held.Enter();
        Run();
        move(held.HostTransform);
        Run(0.5);
        held.Exit();
        Run(1);
    }

    [Test]
    public void Marker_GraspedAndMoved_BaseFollowsAndStays()
    {
        var anchor = Child<BaseAnchor>("Base Anchor").transform;
        var marker = Child<HandPlacedMarker>("Hand-Placed Marker").transform;

        Grasp("Hand-Placed Marker", m => m.SetPositionAndRotation(new Vector3(0.4f, 0.1f, 2), Quaternion.Euler(0, 60, 0)));

        Assert.That(Vector3.Distance(anchor.position, marker.position), Is.LessThan(1e-3));
        Assert.That(Vector3.Distance(anchor.position, new Vector3(0.4f, 0.1f, 2)), Is.LessThan(1e-3));
        Assert.That(Quaternion.Angle(anchor.rotation, marker.rotation), Is.LessThan(0.1));
    }

    [Test]
    public void Panel_HeldByItsBar_StaysUntilFollowIsPressed()
    {
        var panel = Child<BodyFollow>("Status Panel (MRTK3)");

        Grasp("Bar", p => p.position = new Vector3(1, 1, 1));
        Run(2);
        var stays = panel.transform.position;
        Press("Pin");

        Assert.That(stays, Is.EqualTo(new Vector3(1, 1, 1)));
        Assert.That(panel.enabled, Is.True);
    }

    [Test]
    public void Panel_Closed_IsHiddenAndTheMenuShowsIt()
    {
        ShowTheHand();
        Press("Close");

        Assert.That(_actions.IsPanelShown, Is.False);
        Assert.That(Child<PressableButton>("Panel").IsToggled.Active, Is.False);
    }

    [TestCase("Accept", "desk")]
    [TestCase("Refuse", null)]
    public void Consent_CodeInView_IsAskedAndAnsweredByAButton(string button, string expected)
    {
        var codes = ShownCodes.Below(_session);
        codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, new MarkerOffset(0.5, 0, 0), 0.1, 1, 1).Text);
        Show(codes, 2);
        Assert.That(Child<TextMesh>("Question").text, Is.Not.Empty);

        Press(button);

        Assert.That(_session.GetComponent<CellPairing>().Cell, Is.EqualTo(expected));
        Assert.That(Child<Transform>("Content").gameObject.activeSelf, Is.False);
    }

    [TestCase("Accept", null)]
    [TestCase("Refuse", "desk")]
    public void ForgetCell_Pressed_AsksForConfirmation(string button, string left)
    {
        var codes = ShownCodes.Below(_session);
        codes.Texts.Add(new CellCode("desk", "127.0.0.1", null, new MarkerOffset(0.5, 0, 0), 0.1, 1, 1).Text);
        Show(codes, 2);
        Press("Accept");
        codes.Texts.Clear();
        Run(4);
        ShowTheHand();
        Run();

        Press("Forget Cell");
        Run();
        Assert.That(Child<TextMesh>("Question").text, Does.Contain("desk"));
        Assert.That(_session.GetComponent<CellPairing>().Cell, Is.EqualTo("desk"), "asked first");
        Run(2);
        Press(button);
        Run();

        Assert.That(_session.GetComponent<CellPairing>().Cell, Is.EqualTo(left));
    }

    string Message => Child<TextMesh>("Message 0").text.Replace('\n', ' ');

    void Show(ShownCodes codes, double seconds)
    {
        for (var left = seconds; left > 0; left -= 0.02)
        {
            codes.Seen = _cell.Clock.Now;
            Run(0.02);
        }
    }

    [Test]
    public async Task Panel_OfANewHeadset_GuidesThroughThePairingAndShowsFailures()
    {
        var pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));
        var codes = ShownCodes.Below(_session);
        Show(codes, 1);
        Assert.That(Message, Is.EqualTo("look at the robot's marker"));

        codes.Texts.Add(new CellCode("desk", "127.0.0.1", pin, new MarkerOffset(0.5, 0, 0), 0.1, 1, 1).Text);
        Show(codes, 2);
        Press("Accept");
        Show(codes, 1);
        Assert.That(Message, Is.EqualTo("cell 'desk': look at the code that its gateway shows"));

        // Port 1 is closed.
        codes.Texts.Add(new TokenCode(pin, "AAAAAAAAAAAAAAAAAAAAAA").Text);
        await Soon.BecomesAsync(() =>
        {
            Show(codes, 0.3);
            return Message.StartsWith("! pairing with 127.0.0.1: ", StringComparison.Ordinal);
        }, "the panel says why pairing fails");
    }

    [Test]
    public void Interaction_OfAllObjects_SupportsHandPinchAndRay()
    {
        var grasped = _roots.SelectMany(r => r.GetComponentsInChildren<ObjectManipulator>(true)).ToList();

        Assert.That(grasped.Select(g => g.name), Is.EquivalentTo(new[] { "Hand-Placed Marker", "Bar" }));
        foreach (var each in grasped)
        {
            Assert.That(each.AllowedInteractionTypes.HasFlag(InteractionFlags.Near | InteractionFlags.Ray | InteractionFlags.Gaze), each.name);
            Assert.That(each.AllowedManipulations, Is.EqualTo(TransformFlags.Move | TransformFlags.Rotate), each.name + " keeps its size");
            Assert.That(each.GetComponents<Component>().Any(c => c.GetType().Name == "OpaqueComponent"), each.name + " has a box to be hit");
        }
    }

    [Test]
    public void Buttons_OfTheSample_HaveLabelsAndDoNotOverlap()
    {
        var buttons = _roots.SelectMany(r => r.GetComponentsInChildren<PressableButton>(true)).ToList();

        foreach (var button in buttons)
        {
            var words = button.GetComponentsInChildren<TextMeshProUGUI>(true)
                .Where(t => IsShownIn(button.transform, t.transform)).Select(t => t.m_text);
            Assert.That(words.Single(), Is.Not.EqualTo("Label").And.Not.EqualTo("Button"), button.name);
        }
        foreach (var canvas in buttons.GroupBy(b => b.transform.parent))
            foreach (var (a, b) in canvas.SelectMany((a, i) => canvas.Skip(i + 1).Select(b => (a, b))))
                Assert.That(Apart(a.transform, b.transform), Is.GreaterThanOrEqualTo(32), a.name + " and " + b.name);
    }

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
