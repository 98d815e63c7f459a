using System.Globalization;
using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

public class JointStatusTopicTests
{
    readonly SteppedTime _time = new();
    MessageHub _hub;
    JointStatusTopic _topic;
    List<DiagnosticsMessage> _received;

    [SetUp]
    public void Open()
    {
        _hub = new MessageHub();
        _topic = new JointStatusTopic(_hub, new StoppedClock(), _time);
        _received = [];
        _hub.Subscribe(RosTopics.JointStatus, message => _received.Add((DiagnosticsMessage)message.Content));
    }

    [TearDown]
    public void Close() => _topic.Dispose();

    JointSnapshot Joint(string name, JointDataState state, string reason = "", double secondsAgo = 4) =>
        new(name, "press", state, _time.GetUtcNow() - TimeSpan.FromSeconds(secondsAgo), null, 0, reason);

    [Test]
    public void Publish_JointsNotLive_ContainsThemWithTheControlTime()
    {
        _topic.Publish([Joint("a", JointDataState.Live), Joint("b", JointDataState.Rest, "assumed at rest"), Joint("c", JointDataState.Fault, "the node is gone", 1.25)]);

        Assert.That(_received.Single().HardwareId, Is.EqualTo("gateway"));
        Assert.That(_received.Single().Values, Is.EqualTo(new[]
        {
            KeyValuePair.Create("b", "rest 4996.000 assumed at rest"), KeyValuePair.Create("c", "fault 4998.750 the node is gone"),
        }));
    }

    [Test]
    public void Publish_RestUncertain_ReasonContainsTheUncertainty()
    {
        _topic.Publish([Joint("b", JointDataState.Rest, "no change is reported") with { Uncertainty = "the stop itself was not observed" }]);

        Assert.That(_received.Single().Values.Single().Value,
            Is.EqualTo($"rest 4996.000 {EventTexts.UncertainRestReason}the stop itself was not observed"));
    }

    /// <summary>The joint is omitted, because it may have a source at the other gateway of a bridge.</summary>
    [Test]
    public void Publish_JointWithoutAnySource_OmitsTheJoint()
    {
        _topic.Publish([Joint("b", JointDataState.Fault), Joint("c", JointDataState.Missing) with { Source = UnpublishedJoints.NoSource }]);

        Assert.That(_received.Single().Values.Select(pair => pair.Key), Is.EqualTo(new[] { "b" }));
    }

    [Test]
    public void Publish_TooManyJoints_KeepsTheNewestFaults()
    {
        var old = Enumerable.Range(0, 600).Select(i => Joint($"a{i:000}", JointDataState.Stale, secondsAgo: 90_000 + i));
        var resting = Enumerable.Range(0, 300).Select(i => Joint($"b{i:000}", JointDataState.Rest, secondsAgo: 1));

        _topic.Publish([.. old, .. resting, Joint("z", JointDataState.Fault, secondsAgo: 2)]);

        var names = _received.Single().Values.Select(pair => pair.Key).ToList();
        Assert.That(names, Has.Count.EqualTo(ProtocolLimits.Joints).And.Contain("z").And.Contain("a000").And.Not.Contain("a599").And.Ordered);
    }

    [Test]
    public void Publish_LongNamesInNamespaces_KeepsTheNewestFaultsThatFitIntoOneMessage()
    {
        var robot = new string('r', ProtocolLimits.NamespaceLength) + "/";
        var message = default(HubMessage);
        _hub.Subscribe(RosTopics.JointStatus, one => message = one);

        _topic.Publish([.. Enumerable.Range(100, 256).Select(i => Joint($"{robot}{i}".PadRight(161, 'ä'), JointDataState.Fault, secondsAgo: i))]);

        Assert.That(new RosbridgeReader().TryRead(message.Utf8(RosTimeForm.Sec).Span, out var read, out var reason), Is.True, reason.ToString());
        Assert.That(read.JointStatus.Joints.Select(joint => joint.Joint[33..36]), Does.Contain("100").And.Not.Contain("355").And.Ordered);
    }

    [Test]
    public void Publish_CalledRepeatedly_SendsEachChangeAndOncePerSecondWhileAJointIsNotLive()
    {
        JointSnapshot[] fault = [Joint("a", JointDataState.Fault)];
        JointSnapshot[] none = [Joint("a", JointDataState.Live)];
        void Look(JointSnapshot[] joints, double seconds)
        {
            for (var i = 0; i < seconds * 5; i++)
            {
                _topic.Publish(joints);
                _time.Advance(TimeSpan.FromSeconds(0.2));
            }
        }

        Look(none, 3);
        Assert.That(_received, Has.Count.EqualTo(1), "the empty status is sent once");
        Look(fault, 3);
        Assert.That(_received, Has.Count.EqualTo(4), "the change, then each second");
        Look(none, 3);
        Assert.That(_received, Has.Count.EqualTo(5));
        Assert.That(_received[^1].Values, Is.Empty);
    }

    [Test]
    public void Subscribe_AfterPublication_ReceivesTheNewestStatus()
    {
        _topic.Publish([Joint("a", JointDataState.Stale)]);
        var late = new List<HubMessage>();

        _hub.Subscribe(RosTopics.JointStatus, late.Add);

        var text = System.Text.Encoding.UTF8.GetString(late.Single().Utf8(RosTimeForm.Sec).Span);
        Assert.That(text, Does.Contain("\"name\":\"joints\"").And.Contain("\"hardware_id\":\"gateway\"").And.Contain("\"level\":2"));
        Assert.That(text, Does.Contain("\"key\":\"a\",\"value\":\"stale 4996.000\""));
    }

    [Test]
    public void Publish_JointLiveFromOneSource_OmitsTheJoint()
    {
        _topic.Publish([Joint("a", JointDataState.Live), Joint("a", JointDataState.Refused)]);

        Assert.That(_received.Single().Values, Is.Empty);
    }

    [Test]
    public void Publish_ManyJointsWithLongReasons_FitsIntoOneMessage()
    {
        _topic.Publish([.. Enumerable.Range(0, 256).Select(i => Joint(i.ToString("000", CultureInfo.InvariantCulture), JointDataState.Fault, new string('x', 300)))]);

        var late = new List<HubMessage>();
        _hub.Subscribe(RosTopics.JointStatus, late.Add);
        Assert.That(_received.Single().Values, Has.Count.EqualTo(256));
        Assert.That(late.Single().Utf8(RosTimeForm.Secs).Length, Is.LessThan(ProtocolLimits.MessageBytes));
    }

    sealed class StoppedClock : IControlClock
    {
        public ControlTime Now => Gateways.Start;
    }
}
