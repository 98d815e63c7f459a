using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests that a headset can read the list of signals without current values, and which signals have priority in a long list.</summary>
public class SignalStatusTopicTests
{
    MessageHub _hub;
    SignalStatusTopic _topic;
    HubMessage _published;

    [SetUp]
    public void Start()
    {
        _hub = new MessageHub();
        _topic = new SignalStatusTopic(_hub, new StopwatchControlClock(Gateways.Start), () => DateTimeOffset.UnixEpoch);
        _hub.Subscribe(RosTopics.SignalStatus, message => _published = message);
    }

    [TearDown]
    public void Stop() => _topic.Dispose();

    [TestCase(10, ProtocolLimits.Signals, ProtocolLimits.Signals)]
    [TestCase(ProtocolLimits.Signals, 3, ProtocolLimits.Signals)]
    [TestCase(0, ProtocolLimits.Signals + 1, ProtocolLimits.Signals)]
    [TestCase(10, 3, 13)]
    public void Report_WithEndedSignals_ListsAtMost256AndTheReportedSignalsFirst(int ended, int reported, int expected)
    {
        End(Names("ended", ended));

        _topic.Report(Faults(Names("fault", reported)), DateTimeOffset.UnixEpoch);

        Assert.That(Listed().Count, Is.EqualTo(expected));
        Assert.That(Listed().Count(name => name.StartsWith("fault", StringComparison.Ordinal)), Is.EqualTo(Math.Min(reported, ProtocolLimits.Signals)));
    }

    [Test]
    public void Report_LongNamesOfEndedSignals_ListsTheReportedSignal()
    {
        End(Names(new string('ä', ProtocolLimits.NameLength - 3), ProtocolLimits.Signals));
        _topic.Report(Faults(["fault"]), DateTimeOffset.UnixEpoch);
        End(Names(new string('ö', ProtocolLimits.NameLength - 3), ProtocolLimits.Signals));

        Assert.That(Listed(), Does.Contain("fault"));
    }

    [Test]
    public void Report_AfterTheEndOfTheGateway_PublishesNothing()
    {
        _topic.Dispose();
        var before = _published;

        _topic.Report(Faults(["fault"]), DateTimeOffset.UnixEpoch);

        Assert.That(_published, Is.SameAs(before));
    }

    static IEnumerable<string> Names(string start, int count) => Enumerable.Range(0, count).Select(i => $"{start}{i}");

    static List<CellReport> Faults(IEnumerable<string> names) =>
        [.. names.Select(name => new CellReport(name, "plant", new AdapterReport(JointDataState.Fault, DateTimeOffset.UnixEpoch, "no connection")))];

    void End(IEnumerable<string> names)
    {
        using var source = _hub.OpenSource();
        if (names.Any()) source.Publish(new SignalsMessage(Gateways.Start, [.. names.Select(name => new SignalValue(name, 1))]), []);
    }

    List<string> Listed()
    {
        Assert.That(new RosbridgeReader().TryRead(_published.Utf8(RosTimeForm.Sec).Span, out var message, out var reason), Is.True, reason.ToString());
        return message.SignalStatus.Joints.Select(one => one.Joint).ToList();
    }
}
