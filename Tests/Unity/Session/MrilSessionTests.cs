using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Session;

/// <summary>The session component in frames: its resources, its displayed pose and its events.</summary>
public class MrilSessionTests
{
    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

    [Test]
    public void Enable_Component_OwnsASessionUntilDisabled()
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
        Assert.That(session.Frame.HeldJoints[0], Is.Not.EqualTo(truth).Within(1e-4), "or predicting shows nothing");
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

    static bool IsOfLimits(string message) => message.Contains("is outside its limits", StringComparison.Ordinal);

    [Test]
    public void Shown_EachFrame_IsRaisedOnceWithTheCurrentTime()
    {
        var session = _cell.Play();
        var starts = new List<HeadsetTime>();
        session.Shown += frame =>
        {
            starts.Add(frame.Start);
            Assert.That(frame.Start, Is.EqualTo(_cell.Clock.Read), "the newest reading");
            Assert.That(session.Frame, Is.SameAs(frame));
        };

        _cell.Run(1, session);

        Assert.That(starts, Has.Count.EqualTo(Math.Round(_cell.Now * 60)));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Shown_RewriteBeforeRender_IsRaisedTwicePerFrameWithANewerTime()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        session.With("_settings", ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_rewriteBeforeRender", true));
        session.gameObject.SetActive(true);
        var starts = new List<HeadsetTime>();
        session.Shown += frame => starts.Add(frame.Start);
        var updates = 0;
        session.gameObject.AddComponent<FrameProbe>().LateUpdated = () => updates++;

        _cell.Run(1, session);

        Assert.That(starts, Has.Count.EqualTo(2 * updates));
        Assert.That(starts, Is.Ordered.Ascending.And.Unique);
    }

    [Test]
    public void Shown_RewriteBeforeRenderChangedInPlay_AppliesFromTheNextStart()
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        var session = _cell.NewSession().With("_settings", asset);
        session.Settings = null;
        session.gameObject.SetActive(true);
        var shown = 0;
        session.Shown += _ => shown++;

        asset.With("_rewriteBeforeRender", true);
        _cell.Frame(session);
        Assert.That(shown, Is.EqualTo(1));
        session.enabled = false;
        session.enabled = true;
        _cell.Frame(session);

        Assert.That(shown, Is.EqualTo(3));
    }

    [TestCase(true, 2)]
    [TestCase(false, 1)]
    public void Shown_RewriteBeforeRenderByCode_OverridesTheAsset(bool isRewritten, int times)
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_rewriteBeforeRender", !isRewritten);
        var session = _cell.NewSession().With("_settings", asset);
        session.Settings = new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: isRewritten);
        session.gameObject.SetActive(true);
        var shown = 0;
        session.Shown += _ => shown++;

        _cell.Frame(session);

        Assert.That(shown, Is.EqualTo(times));
    }

    [Test]
    public void Shown_UsersScript_RunsBeforeTheComponents()
    {
        var session = _cell.Play();
        var order = new List<string>();
        // Added later: without an execution order it would run after the session.
        session.gameObject.AddComponent<FrameProbe>().LateUpdated = () => order.Add("user");
        session.Shown += _ => order.Add("shown");

        _cell.Frame(session);
        _cell.Frame(session);

        Assert.That(order, Is.EqualTo(new[] { "user", "shown", "user", "shown" }));
    }

    [Test]
    public void Shown_ListenerDisablesTheSession_DoesNotThrow()
    {
        var session = _cell.Play();
        session.Shown += _ => session.enabled = false;

        _cell.Run(0.1, session);

        Assert.That(session.Session, Is.Null);
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

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
        Assert.That(_cell.Messages.Count(m => m.StartsWith("[Nowpose] clock synchronised", StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_cell.Messages.Count(), Is.EqualTo(6), string.Join('\n', _cell.Messages));
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
    public void Pause_WithoutFocus_ResumesWithBoth()
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
    public void Pause_EndsWhileInactive_IsOver()
    {
        var session = _cell.Play();
        _cell.Frame(session);
        _cell.Player.Pause(true);
        session.gameObject.SetActive(false);
        // An inactive object receives no message.
        _cell.Player.Pause(false);

        session.gameObject.SetActive(true);

        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Settings_Invalid_AreLoggedOnceAndOtherSessionsContinue()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_visualisationMs", 900.0);
        session.With("_settings", asset);
        var others = 0;
        session.gameObject.AddComponent<FrameProbe>().LateUpdated = () => others++;
        session.gameObject.SetActive(true);

        _cell.Run(0.1, session);
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        _cell.Run(0.1, session);

        var fault = _cell.Player.Logs.Single();
        Assert.That(fault.Type, Is.EqualTo(LogType.Error));
        Assert.That(fault.Message, Does.StartWith("[Nowpose] ").And.Contain("visualisation latency: 900 ms"));
        Assert.That(fault.Context, Is.SameAs(session));
        Assert.That(session.Problem, Does.Contain("900 ms"));
        Assert.That(session.Session, Is.Null);
        Assert.That(others, Is.GreaterThan(10));

        asset.With("_visualisationMs", 90.0);
        session.enabled = false;
        session.enabled = true;
        Assert.That(session.Session, Is.Not.Null);
        Assert.That(session.Problem, Is.Null);
    }

    [Test]
    public void Settings_CorrectedWhilePaused_ApplyOnceResumed()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        session.gameObject.SetActive(true);
        Assert.That(session.Problem, Is.Not.Null);

        _cell.Player.Pause(true);
        session.Settings = PlayedCell.Offline;
        Assert.That(session.Session, Is.Null);
        _cell.Player.Pause(false);

        Assert.That(session.Session, Is.Not.Null);
        Assert.That(session.Problem, Is.Null);
    }

    [Test]
    public void Settings_None_NamesTheRemedy()
    {
        var session = _cell.NewSession();
        session.Settings = null;

        session.gameObject.SetActive(true);

        Assert.That(_cell.Messages.Single(), Does.Contain("assign a Session Settings asset"));
    }

    [Test]
    public void Settings_SetWhileRunning_StartANewSession()
    {
        var session = _cell.Play();
        _cell.Frame(session);
        var before = session.Session;

        session.Settings = WithLimit(12);

        Assert.That(session.Session, Is.Not.SameAs(before));
        Assert.That(session.Settings.Range.Limit.TotalMilliseconds, Is.EqualTo(12));
    }

    [Test]
    public void RobotAsset_Invalid_IsReportedWithItsName()
    {
        var session = _cell.NewSession();
        session.RobotAsset = RobotDescriptionAsset.Create("Broken", "<robot name='r'/>");

        session.gameObject.SetActive(true);

        Assert.That(session.Problem, Does.Contain("'Broken'"));
        Assert.That(session.Session, Is.Null);
    }

    [Test]
    public void Description_NoRobotAsset_BecomesTheRobot()
    {
        var session = _cell.Play(robot: null);
        var (changes, shown) = (0, 0);
        session.RobotChanged += () => changes++;
        session.Shown += _ => shown++;
        _cell.Run(1, session);
        Assert.That(session.Robot, Is.Null);
        Assert.That(session.Frame, Is.Null);
        Assert.That(shown, Is.EqualTo(0), "no frame is shown without a robot");

        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(5, session);

        Assert.That(session.Robot.Name, Is.EqualTo("ur5"));
        Assert.That(session.Session.Robot, Is.SameAs(session.Robot));
        Assert.That(changes, Is.EqualTo(1));
        Assert.That(session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_cell.Messages.Count(m => m.Contains("describes robot 'ur5'")), Is.EqualTo(1));
    }

    [Test]
    public void Description_AfterAPause_IsTheSameRobotAgain()
    {
        var session = _cell.Play(robot: null);
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.1, session);
        var robot = session.Robot;

        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        var resumed = session.Session;
        resumed.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.1, session);

        Assert.That(session.Robot, Is.SameAs(robot));
        Assert.That(session.Session, Is.SameAs(resumed), "the same text does not restart the session");
        session.Session.Described(RobotFiles.LoadText("youbot"));
        _cell.Run(0.1, session);
        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
    }

    [Test]
    public void Description_DiffersFromTheAsset_IsLoggedOnce()
    {
        var session = _cell.Play("youbot");
        for (var i = 0; i < 3; i++)
        {
            session.Session.Described(RobotFiles.LoadText("ur5"));
            _cell.Run(0.1, session);
            _cell.Player.Pause(true);
            _cell.Player.Pause(false);
        }

        Assert.That(session.Robot.Name, Is.EqualTo("youbot"));
        var warning = _cell.Player.Logs.Single();
        Assert.That(warning.Type, Is.EqualTo(LogType.Warning));
        Assert.That(warning.Message, Does.Contain("'ur5'").And.Contain("'youbot'"));
    }

    [Test]
    public void Description_SameAsTheAsset_IsNotLogged()
    {
        var session = _cell.Play("youbot");

        session.Session.Described(RobotFiles.LoadText("youbot").Replace("\n", "\r\n"));
        _cell.Run(0.1, session);

        Assert.That(_cell.Player.Logs, Is.Empty);
    }

    [Test]
    public void Description_Invalid_IsLoggedOnce()
    {
        var session = _cell.Play(robot: null);

        for (var i = 0; i < 3; i++)
        {
            session.Session.Described("<robot name='r'>");
            _cell.Run(0.1, session);
        }

        Assert.That(session.Robot, Is.Null);
        Assert.That(_cell.Messages.Single(), Does.Contain("/robot_description").And.Contain("cannot be used"));
    }

    [Test]
    public void RobotAsset_Removed_UsesTheGatewaysRobot()
    {
        var session = _cell.Play("youbot");
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Frame(session);

        session.RobotAsset = null;
        Assert.That(session.Robot, Is.Null);
        session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Frame(session);

        Assert.That(session.Robot.Name, Is.EqualTo("ur5"));
    }

    [Test]
    public void Statistics_ReadTwiceInAFrame_AreFilledOnce()
    {
        var session = _cell.Play();
        // Runs beyond the log entry of the synchronised clock, which reads the statistics.
        _cell.Run(3, session);

        var first = session.Statistics;
        var offset = first.Samples;
        _cell.Run(1, session);

        Assert.That(first.Samples, Is.EqualTo(offset), "they have not been read since");
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
