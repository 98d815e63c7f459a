using System.Text.Json;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests service calls and messages of clients that were written for rosbridge.</summary>
public class RosapiTests
{
    [TestCase("/rosapi/topics")]
    [TestCase("rosapi/topics")]
    public async Task Topics_Requested_AreListedWithTheirTypes(string service)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.CallService(service, "1"));

        var text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain("\"" + RosTopics.JointStates + "\"").And.Contain("\"sensor_msgs/JointState\"").And.Contain("\"result\":true"));
        Assert.That(text, Does.Contain("\"service\":\"" + service + "\""), "the response contains the service name of the call");
    }

    [Test]
    public async Task GetTime_WithoutLeadingSlash_IsAnswered()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.CallService("rosapi/get_time", "1"));

        Assert.That((await client.ReceiveAsync()).Result, Is.True);
    }

    const string Described = """{"op":"publish","topic":"/robot_description","msg":{"data":"<robot name='r'><link name='base'/></robot>"}""";

    static readonly string[][] UnsupportedRequests =
    [
        ["""{"op":"subscribe","topic":"/joint_states","compression":"png"}""", "warning", RequestMessages.Compression("png")],
        ["""{"op":"subscribe","topic":"/joint_states","compression":"cbor-raw"}""", "warning", RequestMessages.Compression("cbor-raw")],
        ["""{"op":"subscribe","topic":"/joint_states","fragment_size":1000}""", "warning", RequestMessages.FragmentSize("1000")],
        ["""{"op":"subscribe","topic":"/joint_states","qos":{"depth":1}}""", "warning", RequestMessages.Qos],
        ["""{"op":"subscribe","topic":"/joint_states","compression":"png","unread":NaN}""", "warning", RequestMessages.Compression("png")],
        ["""{"op":"subscribe","topic":"/joint_states","compression":["png"]}""", "warning", RequestMessages.Compression("[\"png\"]")],
        [
            """{"op":"subscribe","topic":"/joint_states","queue_length":5000}""", "warning",
            RequestMessages.QueueLength(5000, Subscription.MaxQueueLength),
        ],
        ["""{"op":"advertise","topic":"/joint_states","latch":true}""", "warning", RequestMessages.Latch("/joint_states")],
        ["""{"op":"advertise","topic":"/joint_states","compression":"png"}""", "warning", RequestMessages.Compression("png")],
        ["""{"op":"set_level","level":"loud"}""", "warning", RequestMessages.Level("loud")],
        [Described + ""","compression":"png"}""", "warning", RequestMessages.Compression("png")],
        [Described + ""","fragment_size":1000}""", "warning", RequestMessages.FragmentSize("1000")],
        [
            Described + ""","type":"std_msgs/Bool"}""", "warning",
            RequestMessages.PublishedType("std_msgs/String", "std_msgs/Bool"),
        ],
        [
            """{"op":"subscribe","topic":"/joint_states","type":"std_msgs/String"}""", "error",
            RequestMessages.OtherType("/joint_states", "sensor_msgs/JointState", "std_msgs/String"),
        ],
        [
            """{"op":"subscribe","topic":"/nowpose/joint_status","type":"std_msgs/String"}""", "error",
            RequestMessages.OtherType("/nowpose/joint_status", "diagnostic_msgs/DiagnosticArray", "std_msgs/String"),
        ],
        ["""{"op":"advertise","topic":"/nowpose/joint_status","type":"diagnostic_msgs/DiagnosticArray"}""", "error", "UnknownTopic"],
        ["""{"op":"publish","topic":"/nowpose/joint_status","msg":{"status":[{"hardware_id":"gateway","values":[]}]}}""", "error", "UnknownTopic"],
        ["""{"op":"subscribe","topic":"joint_states"}""", "error", RequestMessages.NoSlash("joint_states")],
        ["""{"op":"advertise","topic":"joint_states","type":"sensor_msgs/JointState"}""", "error", RequestMessages.NoSlash("joint_states")],
        ["""{"op":"publish","topic":"joint_states","msg":{}}""", "error", RequestMessages.NoSlash("joint_states")],
        [
            """{"op":"advertise","topic":"/joint_states","type":"std_msgs/String"}""", "error",
            "advertise /joint_states dropped: " + RequestMessages.OtherType("/joint_states", "sensor_msgs/JointState", "std_msgs/String"),
        ],
        ["""{"op":"subscribe"}""", "error", "subscribe dropped: " + DropMessages.Of(DropReason.MissingField)],
        ["""{"op":"unsubscribe","topic":"joint_states"}""", "error", RequestMessages.NoSlash("joint_states")],
        ["""{"op":"unsubscribe","topic":"/joint_states"}""", "warning", "unsubscribe /joint_states " + RequestMessages.NotSubscribed(null)],
        ["""{"op":"unadvertise","topic":"joint_states"}""", "error", RequestMessages.NoSlash("joint_states")],
        ["""{"op":"unadvertise","topic":"/joint_states"}""", "warning", RequestMessages.NotAdvertised],
    ];

    [TestCaseSource(nameof(UnsupportedRequests))]
    public async Task Request_Unsupported_ReceivesAStatusWithItsId(string request, string level, string part)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(request.Insert(1, "\"id\":\"7\","));

        var status = await client.ReceiveAsync();
        Assert.That((status.Op, status.Level, status.Id), Is.EqualTo((RosbridgeOp.Status, level, (RequestId)"7")));
        Assert.That(status.Text, Does.Contain(part));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Subscribe_TwoUnsupportedOptions_ReceivesAWarningForEach()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync("""{"op":"subscribe","topic":"/joint_states","compression":"png","fragment_size":1000}""");

        Assert.That((await client.ReceiveAsync()).Text, Does.Contain(RequestMessages.Compression("png")));
        Assert.That((await client.ReceiveAsync()).Text, Does.Contain(RequestMessages.FragmentSize("1000")));
        await client.RoundTripAsync();
    }

    [TestCase("subscribe", "unsubscribe", true)]
    [TestCase("advertise", "unadvertise", false)]
    public async Task UnsubscribeOrUnadvertise_OtherId_CausesAWarningOnlyForASubscription(string op, string withdrawal, bool isWarned)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync($$"""{"op":"{{op}}","topic":"/joint_states","type":"sensor_msgs/JointState","id":"1"}""");

        await client.SendAsync($$"""{"op":"{{withdrawal}}","topic":"/joint_states","id":"2"}""");

        if (isWarned) Assert.That((await client.ReceiveAsync()).Text, Does.Contain(RequestMessages.NotSubscribed("2")));
        await client.RoundTripAsync();
    }

    [TestCase("""{"op":"subscribe","topic":"/joint_states","compression":"none","type":"sensor_msgs/msg/JointState"}""")]
    [TestCase("""{"op":"subscribe","topic":"/joint_states","id":"1"}\n{"op":"unsubscribe","topic":"/joint_states","id":"1"}""")]
    [TestCase("""{"op":"subscribe","topic":"/joint_states","id":"1"}\n{"op":"unsubscribe","topic":"/joint_states"}""")]
    [TestCase("""{"op":"advertise","topic":"/joint_states","type":"sensor_msgs/JointState"}\n{"op":"unadvertise","topic":"/joint_states"}""")]
    [TestCase("""{"op":"subscribe","topic":"/joint_states","compression":"","fragment_size":null}""")]
    [TestCase("""{"op":"subscribe","topic":"/joint_states","queue_length":1024}""")]
    [TestCase("""{"op":"advertise","topic":"/robot_description","latch":true}""")]
    [TestCase("""{"op":"advertise","topic":"/joint_states","latch":false}""")]
    [TestCase("""{"op":"publish","topic":"/robot_description","msg":{"data":"<robot name='compression'><link name='base'/></robot>"},"type":"std_msgs/msg/String","latch":true}""")]
    [TestCase("""{"op":"set_level","level":"error"}\n{"op":"subscribe","topic":"/joint_states","compression":"png"}""")]
    public async Task Request_Supported_ReceivesNoStatus(string requests)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        foreach (var request in requests.Split("\\n")) await client.SendAsync(request);

        await client.RoundTripAsync();
    }

    [TestCase("get_param", """{"name":"/robot_description","default":""}""", """{"value":"\u0022robot of a test\u0022"}""")]
    [TestCase("get_param", """{"name":"robot_state_publisher:robot_description"}""", """{"value":"\u0022robot of a test\u0022"}""")]
    [TestCase("get_param", """{"name":"/none","default":"5"}""", """{"value":"5"}""")]
    [TestCase("has_param", """{"name":"/robot_description"}""", """{"exists":true}""")]
    [TestCase("topic_type", """{"topic":"/nowpose/joint_status"}""", """{"type":"diagnostic_msgs/DiagnosticArray"}""")]
    [TestCase("topics_for_type", """{"type":"diagnostic_msgs/DiagnosticArray"}""", """{"topics":["/nowpose/diagnostics","/nowpose/joint_status","/nowpose/signal_status"]}""")]
    [TestCase("topic_type", """{"topic":"/none"}""", """{"type":""}""")]
    [TestCase("topic_type", "[]", """{"type":""}""")]
    [TestCase("topic_type", """["/joint_states"]""", """{"type":"sensor_msgs/JointState"}""")]
    [TestCase("topics_for_type", """["std_msgs/String"]""", """{"topics":["/robot_description","/nowpose/version"]}""")]
    [TestCase("service_type", """["/rosapi/get_time"]""", """{"type":"rosapi/GetTime"}""")]
    [TestCase("has_param", """["/robot_description"]""", """{"exists":true}""")]
    [TestCase("get_param", """["/none","5"]""", """{"value":"5"}""")]
    [TestCase("get_param", """["/none"]""", """{"value":"null"}""")]
    [TestCase("topic_type", "[5]", """{"type":""}""")]
    [TestCase("service_type", """{"service":"/rosapi/get_time"}""", """{"type":"rosapi/GetTime"}""")]
    [TestCase("get_ros_version", "{}", """{"version":1,"distro":""}""")]
    public async Task Call_RosapiService_ReturnsItsValues(string service, string args, string values)
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Describe("robot of a test");
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync($$"""{"op":"call_service","id":"1","service":"/rosapi/{{service}}","args":{{args}}}""");

        Assert.That(await client.ReceiveTextAsync(), Does.Contain($"\"values\":{values},\"result\":true"));
    }

    // roslib calls the service with the type of ROS 1 also for ROS 2.
    [TestCase(null, "rosapi/GetTime", "sec")]
    [TestCase("sensor_msgs/JointState", "rosapi_msgs/srv/GetTime", "secs")]
    [TestCase("sensor_msgs/msg/JointState", "rosapi/GetTime", "sec")]
    [TestCase("std_msgs/String", null, "sec")]
    public async Task GetTime_AfterAnAdvertisement_HasTheTimeFormOfItsTypeIfItIsAccepted(string advertised, string called, string expected)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        if (advertised != null) await client.SendAsync(RosbridgeWriter.Advertise(RosTopics.JointStates, advertised));

        await client.SendAsync(JsonSerializer.Serialize(new { op = "call_service", service = RosTopics.GetTime, type = called }));

        var text = await client.ReceiveTextAsync();
        if (text.Contains("dropped")) text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain($"\"{expected}\":"));
    }

    [Test]
    public async Task Publish_WithAnotherType_ReceivesAWarningThatNamesTheTopicOnce()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(Gateways.StateText(1).Insert(1, "\"type\":\"std_msgs/String\","));

        var warning = await client.ReceiveAsync();
        Assert.That(warning.Level, Is.EqualTo("warning"));
        Assert.That(warning.Text.Split(RosTopics.JointStates), Has.Length.EqualTo(2), warning.Text);
    }

    [TestCase("none", false)]
    [TestCase("error", true)]
    public async Task SetLevel_AnyLevel_FiltersStatusMessages(string level, bool isSent)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync($$"""{"op":"set_level","level":"{{level}}"}""");

        await client.SendAsync("""{"op":"unheard_of"}""");

        if (isSent) await client.ExpectErrorAsync("Unknown operation");
        await client.RoundTripAsync();
    }
}
