using System.Net.WebSockets;
using System.Text;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Network.PlayedServer;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Tests how the headset handles valid and invalid messages of a server.</summary>
public class RosbridgeClientTests
{
    PlayedServer _played;

    [SetUp]
    public void Start() => _played = new PlayedServer();

    [TearDown]
    public void Stop() => _played.Dispose();

    const string JointStatus = """
        {"op":"publish","topic":"/nowpose/joint_status","msg":{"status":[{"name":"joints","hardware_id":"gateway","values":[{"key":"a3","value":"fault 5.250 node deleted"}]}]}}
        """;

    [Test]
    public async Task Receive_JointStatus_CallsTheListenerAndCountsMalformedMessages()
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, JointStatus.Replace("fault", "broken"));
        await Send(socket, JointStatus);

        await Soon.BecomesAsync(() => _played.Listener.Statuses.Count == 1, "the valid message");
        var joint = _played.Listener.Statuses.Single().Joints.Single();
        Assert.That((joint.Joint, joint.State, joint.Reason), Is.EqualTo(("a3", JointDataState.Fault, "node deleted")));
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { DropReason.OutOfRange }));
    }

    static IEnumerable<TestCaseData> BadMessages()
    {
        yield return new TestCaseData("not json at all", DropReason.NotJson);
        yield return new TestCaseData(Good.Replace("1.5", "NaN"), DropReason.NotFinite);
        yield return new TestCaseData(Good.Replace("[1.5]", "[1.5,2]"), DropReason.LengthMismatch);
        yield return new TestCaseData(new string('[', 10_000) + new string(']', 10_000), DropReason.NotJson);
        yield return new TestCaseData("{\"a\":" + new string('[', 10_000) + new string(']', 10_000) + "}", DropReason.TooDeep);
        yield return new TestCaseData("{\"op\":\"" + new string('x', 2_000_000) + "\"}", DropReason.TooLarge);
        yield return new TestCaseData(Good.Replace("\"secs\":5", "\"secs\":0"), DropReason.StampZero);
    }

    [TestCaseSource(nameof(BadMessages))]
    public async Task Receive_InvalidMessage_CountsItAndReadsTheNext(string message, object reason)
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, message);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "the valid message");
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { (DropReason)reason }));
    }

    [Test]
    public async Task Receive_BinaryMessage_DropsIt()
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, Good, WebSocketMessageType.Binary);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "the valid message");
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { DropReason.NotJson }));
    }

    [TestCase(64, true)]
    [TestCase(65, false)]
    public async Task Receive_ManyFragments_AcceptsThemUpToTheLimit(int fragments, bool taken)
    {
        var socket = await _played.Server.AcceptAsync();
        var perFragment = Good.Length / (fragments - 1);

        for (var i = 0; i < fragments - 1; i++)
            await Send(socket, Good.Substring(i * perFragment, perFragment), end: false);
        await Send(socket, Good[((fragments - 1) * perFragment)..]);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == (taken ? 2 : 1), "the valid messages");
        Assert.That(_played.Listener.Drops, taken ? Is.Empty : Is.EqualTo(new[] { DropReason.TooManyFragments }));
    }

    [Test]
    public async Task Receive_LongFrameInSmallSegments_CountsOneFragment()
    {
        var stream = await _played.Server.AcceptStreamAsync();
        var padded = Good.Replace("\"op\"", "\"padding\":\"" + new string('x', 60_000) + "\",\"op\"");
        var payload = Encoding.UTF8.GetBytes(padded);

        stream.Write([0x81, 126, (byte)(payload.Length >> 8), (byte)payload.Length]);
        for (var at = 0; at < payload.Length; at += 600)
        {
            stream.Write(payload, at, Math.Min(600, payload.Length - at));
            if (at % 3000 == 0) await Task.Delay(1);
        }

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "the message");
    }

    [Test]
    public async Task Receive_CompressedFrame_ClosesWithAnError()
    {
        var stream = await _played.Server.AcceptStreamAsync();

        stream.Write([0xC1, 2, (byte)'{', (byte)'}']);

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting, "waiting");
    }

    [Test]
    public async Task Receive_SetPoints_CallsTheListener()
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, RosbridgeWriter.Publish(RosTopics.JointTrajectory, new JointTrajectoryMessage(
            ControlTime.FromSeconds(5), ["a"], [new JointTrajectoryPoint(TimeSpan.FromSeconds(1), [0.5], [0.25], [-1])]), RosTimeForm.Sec));

        await Soon.BecomesAsync(() => _played.Listener.Plans.Count == 1, "set-points");
        Assert.That(_played.Listener.Plans.Single().Points[0].Accelerations, Is.EqualTo(new[] { -1.0 }));
    }

    [Test]
    public async Task Receive_DescriptionOfNearlyOneMebibyte_CallsTheListener()
    {
        var socket = await _played.Server.AcceptAsync();
        var urdf = new string('x', ProtocolLimits.DescriptionBytes - 100);

        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(urdf)));

        await Soon.BecomesAsync(() => _played.Listener.Descriptions.Count == 1, "a description");
        Assert.That(_played.Listener.Descriptions.Single(), Is.EqualTo(urdf));
    }

    [Test]
    public async Task Receive_DescriptionAboveOneMebibyte_DropsIt()
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(new string('x', ProtocolLimits.DescriptionBytes))));
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "the valid message");
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { DropReason.TooLarge }));
        Assert.That(_played.Listener.Descriptions, Is.Empty);
    }

    [Test]
    public async Task Receive_SlowDescriptionListener_DoesNotDelaySamples()
    {
        using var going = new SemaphoreSlim(0);
        _played.Listener.Describing = _ => going.Wait(Soon.Limit);
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("first")));
        await Soon.BecomesAsync(() => _played.Listener.Descriptions.Count == 1, "the first description");
        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("second")));
        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("third")));
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "the message after the descriptions");
        Assert.That(_played.Listener.Descriptions, Is.EqualTo(new[] { "first" }));
        going.Release(3);
        await Soon.BecomesAsync(() => _played.Listener.Descriptions.Count == 2, "the newest description");
        Assert.That(_played.Listener.Descriptions, Is.EqualTo(new[] { "first", "third" }));
    }

    [Test]
    public async Task Receive_DescriptionListenerThrows_CountsItAndReadsTheNext()
    {
        _played.Listener.Describing = urdf => { if (urdf == "bad") throw new InvalidOperationException("no description today"); };
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("bad")));
        await Soon.BecomesAsync(() => _played.Listener.Drops.Count == 1, "the message is counted as dropped");
        await Send(socket, RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("good")));

        await Soon.BecomesAsync(() => _played.Listener.Descriptions.Contains("good"), "the next description");
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { DropReason.NotUrdf }));
    }
}
