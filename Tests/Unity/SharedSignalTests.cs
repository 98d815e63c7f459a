using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Tests several components that follow the same signal.</summary>
public class SharedSignalTests : PlayedParts
{
    [Test]
    public void Signal_ListenerThrows_OtherComponentsReceiveTheChange()
    {
        var first = Below<CellSignal>("first", _session.transform).With("_signal", "jaw");
        var second = Below<CellSignal>("second", _session.transform).With("_signal", "jaw");
        first.Changed += _ => throw new InvalidOperationException("a mistake of the user");
        var received = new List<double>();
        second.Changed += received.Add;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(0.3);

        Assert.That(received, Is.EqualTo(new[] { 1.0 }));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Exception), Is.EqualTo(1));
    }

    [Test]
    public void Signal_DisabledByAListenerOfTheSameSignal_RaisesNothing()
    {
        var first = Below<CellSignal>("first", _session.transform).With("_signal", "jaw");
        var second = Below<CellSignal>("second", _session.transform).With("_signal", "jaw");
        var received = new List<double>();
        first.Changed += _ => second.gameObject.SetActive(false);
        second.Changed += received.Add;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(0.3);

        Assert.That((received.Count, second.Value), Is.EqualTo((0, (double?)null)));
    }

    [Test]
    public void ActuatedPart_DisabledByAListenerOfItsSignal_ThrowsNothing()
    {
        var signal = Below<CellSignal>("jaw", _session.transform);
        var part = Below<ActuatedPart>("part", _session.transform).With("_signal", "jaw");
        signal.Changed += _ => part.enabled = false;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        Run(0.3);

        Assert.That((part.enabled, part.Share), Is.EqualTo((false, 0f)));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }
}
