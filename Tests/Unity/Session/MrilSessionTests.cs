using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests the session component over several frames: its resources, its displayed pose and its events.</summary>
public class MrilSessionTests
{
    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

    [Test]
    public void LateUpdate_FramesMissRefreshesTwice_LogsTheRemedyAndTheEndOfBoth()
    {
        var session = _cell.Play();
        var states = new List<PoseState>();

        foreach (var hertz in new[] { 60, 120, 60, 120, 60 })
        {
            session.Session.Conditions = new DisplayConditions(displayHz: hertz);
            _cell.Run(2, session);
            states.Add(session.Frame.State);
        }

        Assert.That(states, Is.EqualTo(new[]
        {
            PoseState.Current, PoseState.OutsideRange, PoseState.Current, PoseState.OutsideRange, PoseState.Current,
        }));
        Assert.That(_cell.Messages.Count(m => m.Contains(SessionMessages.RefreshesMissed)), Is.EqualTo(2));
        Assert.That(_cell.Messages.Count(m => m.Contains(SessionMessages.NoRefreshesMissed)), Is.EqualTo(2));
        Assert.That(_cell.Messages, Has.None.Contains(SessionMessages.BeyondRange).And.None.Contains(SessionMessages.WithinRange));
    }

    [Test]
    public void OnEnable_ValidSettings_OwnsASessionUntilDisabled()
    {
        var session = _cell.NewSession();
        Assert.That(session.Session, Is.Null);
        Assert.That(session.Statistics, Is.Null);

        session.gameObject.SetActive(true);
        Assert.That(session.Session, Is.Not.Null);
        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
        _cell.Run(1, session);
        Assert.That(session.Frame, Is.Not.Null);

        session.enabled = false;
        Assert.That(session.Session, Is.Null);
        Assert.That(session.Frame, Is.Null);
        Assert.That(session.Statistics, Is.Null);
    }

    [Test]
    public void Frame_ClockAndSamplesKnown_IsCurrentAndPredicted()
    {
        var session = _cell.Play();

        _cell.Run(5, session);

        Assert.That(session.Frame.State, Is.EqualTo(PoseState.Current));
        var light = session.Frame.Start + TimeSpan.FromMilliseconds(40);
        var truth = PlayedCell.PositionAt(session.Robot, light, 0);
        Assert.That(session.Frame.Joints[0], Is.EqualTo(truth).Within(2e-5));
        Assert.That(session.Frame.HeldJoints[0], Is.Not.EqualTo(truth).Within(1e-4), "the held position differs from the true one");
        Assert.That(session.Statistics.Samples, Is.GreaterThan(90));
    }

    [Test]
    public void Samples_BeyondTheRobotsLimits_AreLoggedOncePerJoint()
    {
        var session = _cell.Play();
        _cell.Run(2, session);
        var before = _cell.Messages.Count(IsOfLimits);

        _cell.Scale = 10_000;
        _cell.Run(20, session);

        var said = _cell.Messages.Where(IsOfLimits).ToList();
        Assert.That(before, Is.Zero);
        Assert.That(said, Has.Some.StartsWith($"[Nowpose] joint '{session.Robot.MovingJoints[0].Name}': "));
        Assert.That(said.Select(line => line.Split('\'')[1]), Is.Unique);
        Assert.That(session.Statistics.BeyondLimits, Is.Not.Null);
    }

    static bool IsOfLimits(string message) =>
        message.Contains(RobotMessages.BeyondLimits("", 0, "", 0, 0, "").Split(", ")[1].Split(';')[0], StringComparison.Ordinal);

    [Test]
    public void Events_ClockAndSamplesStartAndStop_AreEachRaisedOnce()
    {
        var session = _cell.Play(settings: WithLimit(14));
        var raised = new List<string>();
        foreach (var name in new[] { "Synchronised", "Lost", "EnteredRange", "LeftRange", "Stale" }) Listen(session, name, raised);

        void Render(double ms, double seconds) => _cell.Run(
            seconds, session, () => session.Session.Rendered(TimeSpan.FromMilliseconds(ms), RenderTimeSourceKind.DisplayGpuTime));
        Render(10, 5);
        Assert.That(raised, Is.EquivalentTo(new[] { "Synchronised", "EnteredRange" }));
        raised.Clear();
        Render(20, 3);
        Assert.That(raised, Is.EqualTo(new[] { "LeftRange" }));
        raised.Clear();
        _cell.IsPlantUp = false;
        Render(10, 3);
        Assert.That(raised, Is.EquivalentTo(new[] { "EnteredRange", "Stale" }));
        raised.Clear();
        _cell.IsSyncUp = false;
        Render(10, 900);

        Assert.That(raised, Is.EqualTo(new[] { "Lost" }));
        Assert.That(_cell.Messages.Count(m => m.StartsWith("[Nowpose] " + SessionMessages.Synchronised, StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_cell.Messages.Count(m => m == "[Nowpose] " + SessionMessages.FirstPositions), Is.EqualTo(1));
        Assert.That(_cell.Messages.Count(), Is.EqualTo(7), string.Join('\n', _cell.Messages));
        Assert.That(_cell.Player.Logs.Select(log => log.Context), Is.All.SameAs(session));
    }

    [Test]
    public void Pause_Playing_EndsTheSessionImmediatelyAndSynchronisesAgain()
    {
        var session = _cell.Play();
        var raised = new List<SessionChange>();
        session.Changed += raised.Add;
        var hidden = 0;
        session.Hidden += () => hidden++;
        _cell.Run(5, session);
        var before = session.Session;
        Assert.That(session.Frame.State, Is.EqualTo(PoseState.Current));

        _cell.Player.Pause(true);

        Assert.That(session.Session, Is.Null);
        Assert.That(session.Frame, Is.Null);
        Assert.That(hidden, Is.EqualTo(1));
        Assert.That(raised, Is.EqualTo(new[] { SessionChange.Synchronised, SessionChange.Lost }));
        _cell.Player.Pause(false);
        _cell.IsSyncUp = _cell.IsPlantUp = false;
        var states = new HashSet<PoseState>();
        _cell.Run(1, session, () => states.Add(session.Frame.State));
        Assert.That(session.Session, Is.Not.SameAs(before));
        Assert.That(states, Is.EqualTo(new[] { PoseState.Incomplete }));
        _cell.IsSyncUp = _cell.IsPlantUp = true;
        _cell.Run(5, session);
        Assert.That(session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(raised.Skip(2), Is.EqualTo(new[] { SessionChange.Synchronised }));
    }

    [TestCase(true, false)]
    [TestCase(false, true)]
    public void Focus_Lost_EndsTheSessionUnlessItRunsInTheBackground(bool runsInBackground, bool ends)
    {
        Application.runInBackground = runsInBackground;
        var session = _cell.Play();
        _cell.Run(1, session);
        var before = session.Session;

        _cell.Player.Focus(false);

        Assert.That(session.Session, ends ? Is.Null : Is.SameAs(before));
        _cell.Player.Focus(true);
        Assert.That(session.Session, ends ? Is.Not.Null.And.Not.SameAs(before) : Is.SameAs(before));
    }

    [Test]
    public void Pause_WithoutFocus_EndsOnlyWhenTheFocusReturns()
    {
        Application.runInBackground = false;
        var session = _cell.Play();
        _cell.Frame(session);

        _cell.Player.Focus(false);
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        Assert.That(session.Session, Is.Null);
        _cell.Player.Focus(true);

        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Pause_WhileDisabled_IsIgnored()
    {
        var session = _cell.Play();
        _cell.Frame(session);
        session.enabled = false;
        _cell.Player.Pause(true);
        Assert.That(session.Session, Is.Null);
        _cell.Player.Pause(false);
        Assert.That(session.Session, Is.Null, "still disabled");

        session.enabled = true;

        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Pause_EndsWhileInactive_StartsASessionOnActivation()
    {
        var session = _cell.Play();
        _cell.Frame(session);
        _cell.Player.Pause(true);
        session.gameObject.SetActive(false);
        // The object is inactive, so it does not receive the message that ends the pause.
        _cell.Player.Pause(false);

        session.gameObject.SetActive(true);

        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Statistics_NotReadInAFrame_AreNotComputed()
    {
        var session = _cell.Play();
        // Runs until the clock is logged as synchronised, because that log entry reads the statistics.
        _cell.Run(3, session);

        var first = session.Statistics;
        var offset = first.Samples;
        _cell.Run(1, session);

        Assert.That(first.Samples, Is.EqualTo(offset), "the statistics are not updated before they are read again");
        Assert.That(session.Statistics, Is.SameAs(first));
        Assert.That(first.Samples, Is.GreaterThan(offset));
    }

    static SessionSettings WithLimit(double ms) => new(
        PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, range: new ConstantLatencyRange(ms, RenderTimeSourceKind.DisplayGpuTime));

    static void Listen(MrilSession session, string name, List<string> raised)
    {
        var listeners = new UnityEvent();
        listeners.AddListener(() => raised.Add(name));
        session.With("_on" + name, listeners);
    }
}
