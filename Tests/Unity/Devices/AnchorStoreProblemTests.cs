using Microsoft.MixedReality.OpenXR;
using Nowpose.Anchoring;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Tests anchor stores that refuse anchors, that fail, or that are destroyed while they load.</summary>
public sealed class AnchorStoreProblemTests
{
    PlayedAnchorStore _played;

    [SetUp]
    public void SetUp() => _played = new PlayedAnchorStore();

    [TearDown]
    public void TearDown() => _played.Dispose();

    [Test]
    public void Keep_StoreRefusesAtFirst_IsRetried()
    {
        _played.Run(0.1);
        _played.Storage.Accepts = false;
        var anchor = _played.Kept("cell");
        var meanwhile = anchor.Problem;

        _played.Storage.Accepts = true;
        _played.Run(1.1);

        Assert.That(meanwhile, Does.Contain(DeviceMessages.NotStoredYet));
        Assert.That(anchor.KeptAs, Is.EqualTo("cell"));
        Assert.That(anchor.Problem, Is.Null);
    }

    [Test]
    public void Keep_StoreAlwaysRefuses_ReportsTheRefusalAndTheAnchorStaysHeld()
    {
        _played.Run(0.1);
        _played.Storage.Accepts = false;

        var anchor = _played.Kept("cell");
        _played.Run(15);

        Assert.That(anchor.Problem, Is.EqualTo(DeviceMessages.NotStored("cell", problem: null)));
        Assert.That(anchor.State, Is.EqualTo(SpatialAnchorState.Tracking));
    }

    [TestCase(0)]
    [TestCase(0.1)]
    public void Keep_StoreSwitchedOff_IsReportedUntilItIsSwitchedOn(double openFor)
    {
        _played.Run(openFor);
        _played.Store.enabled = false;
        var anchor = _played.Kept("cell");
        var meanwhile = (anchor.KeptAs, anchor.Problem, _played.Anchors.Problem);

        _played.Store.enabled = true;
        _played.Run(2);

        Assert.That(meanwhile, Is.EqualTo(((string)null, DeviceMessages.StoreOff, DeviceMessages.StoreOff)));
        Assert.That((anchor.KeptAs, anchor.Problem), Is.EqualTo(("cell", (string)null)));
    }

    [TestCase("")]
    [TestCase("  ")]
    [TestCase(null)]
    public void Keep_NoName_IsReported(string name) => RefusesName(name, DeviceMessages.AnchorWithoutName);

    // OpenXR limits the bytes, not the characters.
    [TestCase('x', 241, 241)]
    [TestCase('ä', 121, 242)]
    public void Keep_NameTooLong_IsReported(char letter, int count, int bytes) =>
        RefusesName(new string(letter, count), DeviceMessages.AnchorNameTooLong(bytes, 240));

    void RefusesName(string name, string problem)
    {
        _played.Run(0.1);

        var anchor = _played.Kept(name);

        Assert.That(anchor.Problem, Is.EqualTo(problem));
        Assert.That(_played.Storage.PersistedAnchorNames, Is.Empty);
    }

    [Test]
    public void Problem_RuntimeWithoutAStore_IsLoggedOnceAndRetried()
    {
        XRAnchorStore.Loading = _ => Task.FromResult<XRAnchorStore>(null);
        _played.Run(10);
        var problem = _played.Anchors.Problem;

        XRAnchorStore.Loading = _ => Task.FromResult(_played.Storage);
        _played.Run(2);

        Assert.That(problem, Is.EqualTo(DeviceMessages.NoAnchorStore));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains("anchor store 'Anchors'")), Is.EqualTo(1));
        Assert.That(_played.Anchors.IsReady);
        Assert.That(_played.Anchors.Problem, Is.Null);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Problem_LoadingFails_IsReportedWithoutException(bool isAtOnce)
    {
        XRAnchorStore.Loading = _ => isAtOnce
            ? throw new DllNotFoundException("no such library")
            : Task.FromException<XRAnchorStore>(new DllNotFoundException("no such library"));

        _played.Run(3);

        Assert.That(_played.Anchors.Problem, Is.EqualTo(DeviceMessages.StoreFailed(DeviceMessages.LoadAnchors, "no such library")));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains("no such library")), Is.EqualTo(1));
        Assert.That(_played.Cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
        Assert.That(_played.Anchors.Find("cell"), Is.Null);
    }

    [Test]
    public void Problem_StoreThrows_IsReportedWithoutException()
    {
        _played.Run(0.1);
        _played.Storage.Fault = new InvalidOperationException("the store is gone");

        var anchor = _played.Kept("cell");
        var found = _played.Anchors.Find("cell");
        _played.Anchors.Forget("cell");

        Assert.That(found, Is.Null);
        Assert.That(anchor.KeptAs, Is.Null);
        Assert.That(_played.Anchors.Problem, Does.Contain("the store is gone"));
        Assert.That(_played.Cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Update_DestroyedWhileLoading_DoesNotThrow()
    {
        var loading = new TaskCompletionSource<XRAnchorStore>();
        XRAnchorStore.Loading = _ => loading.Task;
        _played.Run(0.1);

        Object.Destroy(_played.Store);
        _played.Run(0.1);
        loading.SetException(new InvalidOperationException("too late"));
        _played.Run(0.1);

        Assert.That(_played.Anchors.IsReady, Is.False);
        Assert.That(_played.Cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }
}
