using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests the settings of the session component: invalid, missing, corrected and replaced.</summary>
public class MrilSessionSettingsTests
{
    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

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
        Assert.That(fault.Message, Is.EqualTo("[Nowpose] " + session.Problem));
        Assert.That(fault.Context, Is.SameAs(session));
        Assert.That(session.Problem, Does.Contain(SettingMessages.OutOfRange("visualisation latency", 900, " ms", 0, LatencyProfile.MaxVisuMs)));
        Assert.That(session.Session, Is.Null);
        Assert.That(others, Is.GreaterThan(10));

        asset.With("_visualisationMs", 90.0);
        session.enabled = false;
        session.enabled = true;
        Assert.That(session.Session, Is.Not.Null);
        Assert.That(session.Problem, Is.Null);
    }

    [Test]
    public void Settings_CorrectedInPlayMode_ApplyWithinASecond()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>().With("_visualisationMs", 900.0);
        session.With("_settings", asset);
        session.gameObject.SetActive(true);

        asset.With("_visualisationMs", 800.0);
        _cell.Run(0.9, session);
        Assert.That(session.Problem, Does.Contain("900 ms"), "not checked in each frame");
        _cell.Run(0.2, session);
        Assert.That(session.Problem, Does.Contain("800 ms"));
        _cell.Run(3, session);
        Assert.That(_cell.Player.Logs, Has.Count.EqualTo(2), "each problem is logged once");

        asset.With("_visualisationMs", 90.0);
        _cell.Run(1.1, session);
        Assert.That((session.Session != null, session.Problem), Is.EqualTo((true, (string)null)));
    }

    [Test]
    public void Settings_AssignedInPlayMode_StartASession()
    {
        var session = _cell.NewSession();
        session.Settings = null;
        session.gameObject.SetActive(true);
        _cell.Run(0.1, session);

        session.With("_settings", ScriptableObject.CreateInstance<SessionSettingsAsset>());
        _cell.Run(1.1, session);

        Assert.That(session.Session, Is.Not.Null);
    }

    [Test]
    public void Settings_CorrectedWhilePaused_ApplyAfterThePause()
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
    public void Settings_Missing_ProblemNamesTheRemedy()
    {
        var session = _cell.NewSession();
        session.Settings = null;

        session.gameObject.SetActive(true);

        Assert.That(_cell.Messages.Single(), Is.EqualTo("[Nowpose] " + ComponentMessages.NoSettings(session.name)));
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

    static SessionSettings WithLimit(double ms) => new(
        PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, range: new ConstantLatencyRange(ms, RenderTimeSourceKind.DisplayGpuTime));
}
