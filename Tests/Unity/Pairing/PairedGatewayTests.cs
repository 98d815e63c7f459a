using Nowpose.Gateway.Messages;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>Tests the whole set-up: a headset without settings sees two codes, and is then connected over TLS with a token of its own.</summary>
public class PairedGatewayTests
{
    PlayedCell _cell;
    PairingGateway _gateway;
    MrilSession _session;
    CellPairing _pairing;
    ShownCodes _shown;

    [SetUp]
    public async Task Start()
    {
        _gateway = await PairingGateway.StartAsync();
        _cell = new PlayedCell();
        Play();
    }

    [TearDown]
    public async Task Stop()
    {
        _cell.Dispose();
        await _gateway.DisposeAsync();
    }

    void Play()
    {
        _session = _cell.NewSession(robot: null);
        _session.HeadsetClock = new StopwatchHeadsetClock();
        _pairing = _session.gameObject.AddComponent<CellPairing>()
            .With("_fileName", Path.Combine(_gateway.Folder, "cells.json")).With("_headsetName", "Anna's");
        _shown = ShownCodes.Below(_session);
        _session.gameObject.SetActive(true);
    }

    void RestartPlaying()
    {
        UnityEngine.Object.Destroy(_session.gameObject);
        _cell.Frame(null);
        Play();
    }

    Task SoonAsync(Func<bool> condition, string what) => Soon.BecomesAsync(() =>
    {
        _shown.Seen = _session.HeadsetClock.Now;
        _cell.Frame(null);
        return condition();
    }, what + ": " + _pairing.Words);

    bool IsConnected => _session.Session is { } session
        && session.SampleLink.State == LinkState.Connected && session.SyncLink.State == LinkState.Connected;

    async Task PairAsync()
    {
        _shown.Texts.Add(_gateway.CellCode().Text);
        await SoonAsync(() => _pairing.Question != null, "a question appears");
        _pairing.Accept();
        _shown.Texts.Add((await _gateway.ShownAsync()).Text);
        await SoonAsync(() => IsConnected, "connected");
    }

    [Test]
    public async Task Headset_SeesBothCodesOnce_IsPairedPermanently()
    {
        var paired = 0;
        var onPaired = new UnityEvent();
        onPaired.AddListener(() => paired++);
        _pairing.With("_onPaired", onPaired);

        await PairAsync();

        Assert.That(paired, Is.EqualTo(1));
        Assert.That(_session.Settings.Connection.Security, Is.EqualTo(TransportSecurity.Pinned));
        Assert.That(_pairing.Words, Does.Contain("paired"));
        Assert.That(_gateway.Log, Has.Some.StartsWith(PairingServiceMessages.TokenGiven + PairingServiceMessages.To("Anna's")));

        RestartPlaying();
        await SoonAsync(() => IsConnected, "connected again");
        Assert.That(_pairing.Question, Is.Null);
        Assert.That(_gateway.Log.Count(line => line.StartsWith(PairingServiceMessages.TokenGiven, StringComparison.Ordinal)), Is.EqualTo(1), "the headset connects with its stored token");
    }

    [Test]
    public async Task Token_RevokedAndNewCodeSeen_IsReplaced()
    {
        await PairAsync();
        Assert.That(_pairing.Guidance, Is.Null);
        File.WriteAllText(_gateway.ListPath, "");
        RestartPlaying();
        await SoonAsync(() => _session.Session?.SampleLink.IsTokenRefused == true && _pairing.Guidance != null, "refused");
        Assert.That(_pairing.Guidance, Is.EqualTo(PairingMessages.TokenRefused(_pairing.Cell)));

        _shown.Texts.Add((await _gateway.ShownAsync()).Text);
        await SoonAsync(() => IsConnected, "connected");

        Assert.That(_pairing.Problem, Is.Null);
    }

    [Test]
    public async Task Code_AlreadyUsed_IsReportedAndTheNextCodeWorks()
    {
        var used = await _gateway.ShownAsync();
        await _gateway.ExchangeAsync(used.Token, "another headset");
        _shown.Texts.Add(_gateway.CellCode().Text);
        await SoonAsync(() => _pairing.Question != null, "a question appears");
        _pairing.Accept();

        _shown.Texts.Add(used.Text);
        await SoonAsync(() => _pairing.Problem != null, "a problem");

        Assert.That(_pairing.Words, Does.Contain(PairingAnswerMessages.NotAccepted));
        _shown.Texts.Add((await _gateway.ShownAsync()).Text);
        await SoonAsync(() => IsConnected, "connected");
    }

    [Test]
    public async Task Console_WhilePairing_NeverShowsASecret()
    {
        var code = await _gateway.ShownAsync();

        await PairAsync();

        var own = _session.Settings.Connection.Token;
        Assert.That(string.Join('\n', _cell.Messages.Concat(_gateway.Log)), Does.Not.Contain(own).And.Not.Contain(code.Token));
    }
}
