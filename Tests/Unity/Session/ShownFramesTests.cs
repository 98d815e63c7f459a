using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests when and how often a session raises its event Shown.</summary>
public class ShownFramesTests
{
    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

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
    public void Shown_DefaultSettings_IsRaisedTwicePerFrameWithANewerTime()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        session.With("_settings", ScriptableObject.CreateInstance<SessionSettingsAsset>());
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
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_rewriteBeforeRender", false);
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
    public void Shown_RewriteBeforeRenderSetByCode_OverridesTheAsset(bool isRewritten, int times)
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
        // The script is added after the session, so it would run after the session if the session had no execution order.
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
}
