using System.Reflection;
using Nowpose.Messages;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>Tests the calibration by eye as a wearer uses it: by the methods that buttons call, with the reports on the status panel.</summary>
public sealed class NudgeActionsTests
{
    PlayedCell _cell;
    MrilSession _session;
    CellActions _actions;
    LatencyNudge _nudge;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSessionOf("Nowpose Robot Cell");
        _actions = _session.gameObject.AddComponent<CellActions>();
        _nudge = _session.GetComponent<LatencyNudge>();
        _session.gameObject.SetActive(true);
        _cell.Run(5, _session);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    string PanelNow()
    {
        _cell.Run(0.5, _session);
        return _session.GetComponentInChildren<StatusPanel>().Texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
    }

    [Test]
    public void Actions_NudgeSwitchedOff_EnableItAndReportOnThePanel()
    {
        Assert.That((_nudge.enabled, PanelNow()), Is.EqualTo((false, "")));

        _actions.SetShiftMm(3);
        _actions.ChangeShiftMm(-1);
        Assert.That((_nudge.enabled, _nudge.OffsetMm), Is.EqualTo((true, 2f)));
        Assert.That(PanelNow(), Is.EqualTo(NudgeReports.Progress(2, NudgeAxis.X, 0, 0)));

        _actions.AddMark();
        Assert.That(_nudge.Problem, Is.Not.Null, "the arm is too slow");
        Assert.That(PanelNow(), Is.EqualTo("! " + _nudge.Problem));

        _actions.ApplyMarks();
        Assert.That((_nudge.Problem, PanelNow()), Is.EqualTo((NudgeMessages.NoMark(isForward: true), "! " + _nudge.Problem)));

        _actions.ChangeShiftMm(0);
        Assert.That(PanelNow(), Is.EqualTo(NudgeReports.Progress(2, NudgeAxis.X, 0, 0)), "the next mark");

        _actions.ApplyMarks();
        _actions.ClearMarks();
        Assert.That((_nudge.Problem, _nudge.OffsetMm, PanelNow()), Is.EqualTo(((string)null, 0f, "")));

        _actions.SetShiftMm(2);
        Assert.That(PanelNow(), Is.EqualTo(NudgeReports.Progress(2, NudgeAxis.X, 0, 0)));

        _nudge.enabled = false;
        Assert.That(PanelNow(), Is.Empty);
    }

    [Test]
    public void Shift_UntilClearedWithoutMarks_IsShownOnTheRobot()
    {
        var look = _session.GetComponentsInChildren<RobotRig>().First(rig => rig.Shows == RigPose.Displayed).GetComponentInChildren<PoseAppearance>();

        _actions.SetShiftMm(12);
        _cell.Run(0.1, _session);
        Assert.That((look.Look.Label, look.Look.IsHatched), Is.EqualTo((PoseMessages.Shifted, true)));

        _actions.ClearMarks();
        _cell.Run(0.1, _session);
        Assert.That((_nudge.OffsetMm, look.Look.Label, look.Look.IsHatched), Is.EqualTo((0f, "", false)));
    }

    [Test]
    public void Actions_NoNudge_AreReported()
    {
        UnityEngine.Object.DestroyImmediate(_nudge);

        _actions.AddMark();

        Assert.That(_cell.Messages, Has.Exactly(1).Contains(ComponentMessages.NoCalibration(_actions.name)));
    }

    // Unity's Inspector offers only methods without a return value for an event.
    [Test]
    public void ActionsOfTheManual_ReturnNothing()
    {
        foreach (var name in new[] { "SetShiftMm", "ChangeShiftMm", "AddMark", "ApplyMarks", "ClearMarks" })
            Assert.That(typeof(CellActions).GetMethod(name, BindingFlags.Public | BindingFlags.Instance).ReturnType, Is.EqualTo(typeof(void)), name);
    }

    [Test]
    public void Mark_CannotBeSet_StatesTheReason()
    {
        Assert.That((_nudge.Mark(), _nudge.Problem), Is.EqualTo((false, NudgeReports.Disabled)));

        _nudge.enabled = true;
        _session.enabled = false;
        Assert.That((_nudge.Mark(), _nudge.Problem), Is.EqualTo((false, NudgeReports.NotRunning)));

        var alone = new GameObject("alone").AddComponent<LatencyNudge>();
        Assert.That((alone.Mark(), alone.Problem), Is.EqualTo((false, NudgeReports.NoSession)));
    }

    [Test]
    public void Panel_NudgeInUse_AllocatesNothing()
    {
        _actions.SetShiftMm(3);
        _cell.Run(1, _session);

        Assert.That(_cell.AllocatedIn(() => _cell.Run(1, _session)), Is.Zero);
    }
}
