using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests that a listener of an event of the session component may change the component in any way.</summary>
public class SessionListenersTests
{
    static readonly string[] Events =
        ["Hidden", "Changed", "RobotChanged", "Shown", "Synchronised", "Lost", "EnteredRange", "LeftRange", "Stale"];

    static readonly SessionSettings Others = With(90);

    static readonly Dictionary<string, Action<MrilSession>> Actions = new()
    {
        ["disable"] = session => session.enabled = false,
        ["deactivate"] = session => session.gameObject.SetActive(false),
        ["destroy"] = session => UnityEngine.Object.DestroyImmediate(session.gameObject),
        ["destroy later"] = session => UnityEngine.Object.Destroy(session),
        ["disable and enable"] = session => session.enabled = !(session.enabled = false),
        ["settings"] = session => session.Settings = Others,
        ["no settings"] = session => session.Settings = null,
        ["another robot"] = session => session.RobotAsset = Robot("ur5"),
        ["no robot"] = session => session.RobotAsset = null,
        ["a broken robot"] = session => session.RobotAsset = RobotDescriptionAsset.Create("Broken", "<robot name='r'/>"),
        ["disconnect"] = session => session.Disconnect(),
    };

    static readonly Dictionary<string, Action<PlayedCell, MrilSession>> Causes = new()
    {
        ["late"] = (_, _) => { },
        ["stale"] = (cell, _) => cell.IsPlantUp = false,
        ["settings"] = (_, session) => session.Settings = With(50),
        ["robot"] = (_, session) => session.RobotAsset = Robot("ur5"),
        ["no robot"] = (_, session) => session.RobotAsset = null,
        ["description"] = (_, session) =>
        {
            session.RobotAsset = null;
            session.Session?.Described(RobotFiles.LoadText("ur5"));
        },
        ["disabled"] = (_, session) => session.enabled = false,
        ["enabled"] = (_, session) =>
        {
            session.enabled = false;
            if (session != null) session.enabled = true;
        },
        ["paused"] = (cell, _) => cell.Player.Pause(true),
        ["resumed"] = (cell, _) =>
        {
            cell.Player.Pause(true);
            cell.Player.Pause(false);
        },
    };

    PlayedCell _cell;
    MrilSession _session;
    HashSet<CompensationSession> _sessions;

    static IEnumerable<string> ActionNames => Actions.Keys;

    [SetUp]
    public void Start()
    {
        _cell = new PlayedCell();
        _sessions = [];
    }

    [TearDown]
    public void Stop() => _cell.Dispose();

    [Test]
    public async Task Listener_ChangesTheSession_LeaksNothing(
        [ValueSource(nameof(Events))] string heard, [ValueSource(nameof(ActionNames))] string action)
    {
        var heardInAll = 0;
        foreach (var cause in Causes.Keys)
        {
            _cell.Dispose();
            Start();
            var label = $"{heard}, {action}, {cause}";
            Begin();
            var count = 0;
            Listen(heard, () =>
            {
                // Runs the action only for the first two events, so that the sequence ends.
                if (count++ < 2 && _session != null) Actions[action](_session);
                Note(label);
            });

            Causes[cause](_cell, _session);
            Note(label);
            // After a pause, the time must be long enough to synchronise the clock again.
            for (var i = 0; i < (cause == "resumed" ? 360 : 60); i++)
            {
                Frame(cause == "late" ? 20 : 10);
                Note(label);
            }
            heardInAll += count;
            count = 2;
            Finish();

            Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception).Select(log => log.Message), Is.Empty, label);
            foreach (var each in _sessions)
            {
                Assert.That((each.SyncLink.State, each.SampleLink.State), Is.EqualTo((LinkState.Idle, LinkState.Idle)), label);
                await each.Ended.Bounded();
            }
        }

        Assert.That(heardInAll, Is.GreaterThan(0), "the test raised at least one event");
    }

    [Test]
    public void HiddenEvent_ListenerDisablesTheSession_StartsNoSession()
    {
        Begin();
        _session.Hidden += () => _session.enabled = false;

        _session.Settings = Others;

        Assert.That(_session.Session, Is.Null);
    }

    [Test]
    public void RobotChanged_ListenerSetsSettings_RunsWithThoseSettings()
    {
        Begin();
        _session.RobotChanged += () => _session.Settings = Others;

        _session.RobotAsset = Robot("ur5");

        Assert.That(_session.Session.Visualisation, Is.EqualTo(Others.Visualisation));
        Assert.That(_session.Session.Robot.Name, Is.EqualTo("ur5"));
    }

    [Test]
    public void RobotChanged_ListenerSetsInvalidSettings_LogsAndDoesNotRun()
    {
        Begin();
        _session.RobotChanged += () => _session.Settings = null;

        _session.RobotAsset = Robot("ur5");

        Assert.That(_session.Session, Is.Null);
        Assert.That(_session.Problem, Is.EqualTo(ComponentMessages.NoSettings(_session.name)));
    }

    [Test]
    public void HiddenEvent_ListenerEnablesTheDisabledSession_KeepsItsProblem()
    {
        Begin();
        _session.Hidden += () =>
        {
            _session.Settings = null;
            _session.enabled = true;
        };

        _session.enabled = false;

        Assert.That(_session.isActiveAndEnabled, Is.True);
        Assert.That(_session.Problem, Is.EqualTo(ComponentMessages.NoSettings(_session.name)));
    }

    [Test]
    public void Synchronised_ListenerRestartsTheSession_OtherListenersAreNotified()
    {
        _session = _cell.Play();
        var raised = new List<SessionChange>();
        Listen("Synchronised", () => _session.Settings = Others);
        _session.Changed += raised.Add;

        _cell.Run(6, _session);

        Assert.That(raised.Take(2), Is.EqualTo(new[] { SessionChange.Synchronised, SessionChange.Lost }));
    }

    [Test]
    public void Changed_ListenerThrows_LaterChangesAreRaised()
    {
        _session = _cell.Play();
        var raised = new List<SessionChange>();
        _session.Changed += change =>
        {
            raised.Add(change);
            throw new InvalidOperationException("thrown by the listener");
        };

        _cell.Run(6, _session);
        _session.Settings = Others;

        Assert.That(raised, Is.EqualTo(new[] { SessionChange.Synchronised, SessionChange.Lost }));
    }

    static RobotDescriptionAsset Robot(string name) => RobotDescriptionAsset.Create(name, RobotFiles.LoadText(name));

    static SessionSettings With(double visualisationMs) =>
        new(PlayedCell.Offline.Connection, VisualisationLatency.FromMilliseconds(visualisationMs),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime));

    // Starts a session with a current pose and with connections. A session that is not disposed would keep its connections open.
    void Begin()
    {
        _session = _cell.Play(settings: With(40));
        _session.Connect();
        for (var i = 0; i < 300; i++) Frame(10);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Note("at first");
    }

    void Frame(double renderMs)
    {
        if (_session != null) _session.Session?.Rendered(TimeSpan.FromMilliseconds(renderMs), RenderTimeSourceKind.DisplayGpuTime);
        _cell.Frame(_session);
    }

    void Note(string label)
    {
        if (_session is null) return;
        if (_session.Session != null) _sessions.Add(_session.Session);
        if (_session == null || !_session.isActiveAndEnabled) return;
        Assert.That(_session.Session == null && _session.Frame != null, Is.False, label);
    }

    void Finish()
    {
        if (_session != null) _session.enabled = false;
        Assert.That(_session.Session, Is.Null);
        if (_session != null) UnityEngine.Object.DestroyImmediate(_session.gameObject);
    }

    void Listen(string name, Action heard)
    {
        if (name == "Hidden") _session.Hidden += heard;
        else if (name == "RobotChanged") _session.RobotChanged += heard;
        else if (name == "Changed") _session.Changed += _ => heard();
        else if (name == "Shown") _session.Shown += _ => heard();
        else
        {
            var listeners = new UnityEvent();
            listeners.AddListener(() => heard());
            _session.With("_on" + name, listeners);
        }
    }
}
