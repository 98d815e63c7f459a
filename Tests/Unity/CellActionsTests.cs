using System.Reflection;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

public sealed class CellActionsTests
{
    PlayedCell _cell;
    MrilSession _session;
    CellActions _actions;
    int _changes;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSessionOf("Nowpose Robot Cell");
        _actions = _session.gameObject.AddComponent<CellActions>();
        _changes = 0;
        _actions.Changed += () => _changes++;
        _session.gameObject.SetActive(true);
        Run(5);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Run(double seconds) => _cell.Run(seconds, _session);

    T Find<T>(string name) where T : Component => _session.GetComponentsInChildren<T>(true).First(c => c.name == name);

    float FadeOf(string part)
    {
        var block = new MaterialPropertyBlock();
        Find<Transform>(part).GetComponentInChildren<MeshRenderer>().GetPropertyBlock(block);
        return block.GetFloat(Shader.PropertyToID("_Fade"));
    }

    float HatchOf(string part)
    {
        var block = new MaterialPropertyBlock();
        Find<Transform>(part).GetComponentInChildren<MeshRenderer>().GetPropertyBlock(block);
        return block.GetFloat(Shader.PropertyToID("_Hatch"));
    }

    [Test]
    public void ToggleConnected_Twice_ConnectsAndDisconnects()
    {
        _actions.ToggleConnected();
        var first = (_session.IsConnecting, _actions.IsConnecting);
        _actions.ToggleConnected();

        Assert.That(first, Is.EqualTo((true, true)));
        Assert.That(_session.IsConnecting, Is.False);
        Assert.That(_session.Session.SampleLink, Is.EqualTo(Nowpose.Network.LinkStatus.Idle));
    }

    [Test]
    public void ToggleConnected_Disabled_ConnectsAndDisconnects()
    {
        _actions.enabled = false;

        _actions.ToggleConnected();
        Assert.That((_session.IsConnecting, _actions.IsConnecting), Is.EqualTo((true, true)));
        _actions.ToggleConnected();

        Assert.That((_session.IsConnecting, _actions.IsConnecting), Is.EqualTo((false, false)));
    }

    [Test]
    public void Actions_NeverEnabled_ChangePanelAndOpacity()
    {
        var menu = new GameObject("Menu");
        menu.SetActive(false);
        menu.transform.SetParent(_session.transform, false);
        var actions = menu.AddComponent<CellActions>();
        var isShown = _actions.IsPanelShown;

        actions.TogglePanel();
        actions.ChangeOpacity(-0.75f);

        Assert.That((_actions.IsPanelShown, _actions.Opacity), Is.EqualTo((!isShown, 0.25f)));
    }

    [Test]
    public void ToggleGhost_Hidden_IsShown()
    {
        _actions.ToggleGhost();

        Assert.That(Find<Ghost>("Ghost").Visible, Is.True);
        Assert.That(_actions.IsGhostShown, Is.True);
    }

    [Test]
    public void ToggleGhost_SeveralGhosts_SwitchesThoseOfAllRobotsAndObjectsOfTheSession()
    {
        var second = UnityEngine.Object.Instantiate(Find<Ghost>("Ghost").gameObject, _session.transform);
        second.name = "Second Ghost";
        var box = PlayedRig.Below<TrackedObject>("Ghost of Box", _session.transform).With("_shows", RigPose.Held);
        var elsewhere = new GameObject("Ghost of Lid").AddComponent<TrackedObject>().With("_shows", RigPose.Held);
        var other = new GameObject("Ghost of Another Cell").AddComponent<TrackedObject>().With("_shows", RigPose.Held);
        var displayed = PlayedRig.Below<TrackedObject>("Box", _session.transform);
        elsewhere.With("_session", _session);
        bool[] Shown() => [Find<Ghost>("Ghost").Visible, second.activeSelf, box.gameObject.activeSelf, elsewhere.gameObject.activeSelf];

        _actions.SetGhost(true);
        Assert.That((Shown(), _actions.IsGhostShown), Is.EqualTo((new[] { true, true, true, true }, true)));
        second.SetActive(false);
        _actions.ToggleGhost();
        Assert.That((Shown(), _actions.IsGhostShown), Is.EqualTo((new[] { false, false, false, false }, false)));
        _actions.ToggleGhost();
        Assert.That((Shown(), _actions.IsGhostShown), Is.EqualTo((new[] { true, true, true, true }, true)));
        _actions.SetGhost(false);

        Assert.That((displayed.gameObject.activeSelf, other.gameObject.activeSelf), Is.EqualTo((true, true)));
    }

    [Test]
    public void SetOpacity_ObjectsAndGripperWithAppearances_FadesTheRobotAndItsGripperOnly()
    {
        _cell.Dispose();
        _cell = new PlayedCell();
        _session = _cell.NewSession();
        var box = PlayedRig.Below<TrackedObject>("box", _session.transform);
        var rig = PlayedRig.Below<RobotRig>("Robot", _session.transform);
        var gripper = PlayedRig.Below<VirtualGripper>("Gripper", rig.transform);
        var held = PlayedRig.Below<TrackedObject>("held", rig.transform);
        PoseAppearance[] looks = [rig.gameObject.AddComponent<PoseAppearance>(), gripper.gameObject.AddComponent<PoseAppearance>()];
        _actions = _session.gameObject.AddComponent<CellActions>();
        _session.gameObject.SetActive(true);
        Run(0.1);

        _actions.SetOpacity(0.5f);

        Assert.That(looks.Select(look => look.Opacity), Is.Not.Empty.And.All.EqualTo(0.5f));
        Assert.That((box.GetComponent<PoseAppearance>().Opacity, held.GetComponent<PoseAppearance>().Opacity), Is.EqualTo((1f, 1f)));
    }

    [Test]
    public void TogglePanel_Shown_IsHidden()
    {
        _actions.TogglePanel();

        Assert.That(Find<StatusPanel>("Status Panel").gameObject.activeSelf, Is.False);
        Assert.That(_actions.IsPanelShown, Is.False);
    }

    [TestCase(0.4f, 0.6f)]
    [TestCase(2f, 0f)]
    [TestCase(-1f, 1f)]
    [TestCase(float.NaN, 0f)]
    public void SetOpacity_PoseIsCurrent_FadesTheGripperNotTheGhost(float opacity, float fade)
    {
        _actions.SetOpacity(opacity);
        Run(0.1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(FadeOf("Palm"), Is.EqualTo(fade).Within(1e-6));
        Assert.That(_actions.Opacity, Is.EqualTo(1 - fade).Within(1e-6));
        Assert.That(Find<PoseAppearance>("Ghost").Opacity, Is.EqualTo(1));
    }

    [TestCase(0f, 1f)]
    [TestCase(0.5f, 0.8f)]
    [TestCase(1f, 0.5f)]
    public void SetOpacity_PoseIsHeld_KeepsStripesAndIsFainterThanACurrentPose(float opacity, float fade)
    {
        _actions.SetOpacity(opacity);

        _cell.IsPlantUp = false;
        Run(1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Held));
        Assert.That(FadeOf("Palm"), Is.EqualTo(fade).Within(1e-6));
        Assert.That(HatchOf("Palm"), Is.EqualTo(1));
    }

    [Test]
    public void SetNudgeMs_SessionRunning_ShiftsTheDisplayTime()
    {
        var before = DisplayTimeAhead();

        _actions.SetNudgeMs(12);
        Run(0.1);

        Assert.That((DisplayTimeAhead() - before).TotalMilliseconds, Is.EqualTo(12).Within(0.01));
        Assert.That(_actions.NudgeMs, Is.EqualTo(12));
    }

    [Test]
    public void ChangeMethods_CalledRepeatedly_AddUpWithinTheLimits()
    {
        for (var press = 0; press < 3; press++) _actions.ChangeNudgeMs(-2);
        _actions.ChangeOpacity(-0.25f);
        Assert.That(_actions.NudgeMs, Is.EqualTo(-6));
        Assert.That(_actions.Opacity, Is.EqualTo(0.75f));

        for (var press = 0; press < 100; press++) _actions.ChangeNudgeMs(-2);
        for (var press = 0; press < 9; press++) _actions.ChangeOpacity(0.25f);
        Assert.That(_actions.NudgeMs, Is.EqualTo(-40), "L_visu plus the nudge is not negative");
        Assert.That(_actions.Opacity, Is.EqualTo(1));
    }

    // Display time minus start of the frame. It contains the offset of the two clocks, which is constant, so only differences are meaningful.
    TimeSpan DisplayTimeAhead() => _session.Frame.DisplayTime.Value.SinceEpoch - _session.Frame.Start.SinceEpoch;

    [Test]
    public void SetNudgeMs_SessionRestarts_IsKept()
    {
        _actions.SetNudgeMs(12);
        Run(0.1);

        _session.Settings = PlayedCell.Offline;
        Run(0.1);

        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(52).Within(1e-6));
    }

    [Test]
    public void Changed_AnotherScriptChangesTheState_IsRaisedOnce()
    {
        Assert.That(_changes, Is.Zero);

        Find<Ghost>("Ghost").Visible = true;
        Run(0.5);

        Assert.That(_changes, Is.EqualTo(1));
    }

    [Test]
    public void PublicMethods_All_AreCallableByUnityEvents()
    {
        var methods = typeof(CellActions).GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly)
            .Where(m => !m.IsSpecialName);

        foreach (var method in methods)
        {
            Assert.That(method.ReturnType, Is.EqualTo(typeof(void)), method.Name);
            Assert.That(
                method.GetParameters().Select(p => p.ParameterType), Is.Empty.Or.EqualTo(new[] { typeof(bool) }).Or.EqualTo(new[] { typeof(float) }),
                method.Name);
        }
    }

    [Test]
    public void Actions_ComponentsMissing_LogTheMissingComponentsAndContinue()
    {
        var lone = new GameObject("Buttons").AddComponent<CellActions>();

        lone.ToggleConnected();
        lone.ToggleGhost();
        lone.LockBase();
        lone.SetOpacity(0.5f);
        lone.SetNudgeMs(3);
        Run(0.1);

        Assert.That(_cell.Messages, Has.Some.Contains(ComponentMessages.NoAction("Buttons", "session")));
        Assert.That(_cell.Messages, Has.Some.Contains(ComponentMessages.NoAction("Buttons", "ghost")));
        Assert.That(lone.Opacity, Is.EqualTo(1));
    }

    [Test]
    public void Changed_ListenerThrows_CallsTheLaterOnes()
    {
        var calls = 0;
        _actions.Changed += () => throw new InvalidOperationException();
        _actions.Changed += () => calls++;

        _actions.ToggleConnected();
        Run(0.1);

        Assert.That(calls, Is.EqualTo(1));
    }

    [Test]
    public void SetOpacity_AppearanceAboveTheRig_FadesIt()
    {
        _cell.Dispose();
        _cell = new PlayedCell();
        _session = _cell.NewSession();
        var appearance = PlayedRig.Below<PoseAppearance>("Look", _session.transform);
        PlayedRig.Below<RobotRig>("Robot", appearance.transform);
        _actions = _session.gameObject.AddComponent<CellActions>();
        _session.gameObject.SetActive(true);

        _actions.SetOpacity(0.25f);

        Assert.That((appearance.Opacity, _actions.Opacity), Is.EqualTo((0.25f, 0.25f)));
    }
}
