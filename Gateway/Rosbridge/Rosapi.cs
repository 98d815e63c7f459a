using System.Text.Json;
using System.Text.Json.Nodes;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Provides the rosapi services that clients call when they connect. The responses describe the gateway as one ROS node.</summary>
/// <remarks>
/// <see cref="RosbridgeSession"/> provides /rosapi/get_time and /rosapi/topics. Type names have the format of the caller's ROS version, or of
/// ROS 1 while that version is unknown.
/// </remarks>
static class Rosapi
{
    const string Node = "/nowpose_gateway";
    const string Prefix = "/rosapi/";
    const string Description = RosTopics.RobotDescription;

    delegate JsonObject Answer(RosapiCall call);

    static readonly Dictionary<string, (string Type, Answer Answer)> Services = new()
    {
        ["topics_and_raw_types"] = ("TopicsAndRawTypes", call => new()
        {
            ["topics"] = List(TopicsOf(call)), ["types"] = List(TypesOf(call)), ["typedefs_full_text"] = List(TypesOf(call).Select(call.Definitions.FullText)),
        }),
        ["topics_for_type"] = ("TopicsForType", call => new()
        {
            ["topics"] = List(TopicsOf(call).Where(topic => Publications.HasType(RobotTopic.Parse(topic), call.Argument("type") ?? "-"))),
        }),
        ["topic_type"] = ("TopicType", call => new() { ["type"] = TypeOf(call, call.Argument("topic")) }),
        ["message_details"] = ("MessageDetails", call => new()
        {
            ["typedefs"] = JsonSerializer.SerializeToNode(call.Definitions.Details(call.Argument("type") ?? "")),
        }),
        ["services"] = ("Services", _ => new() { ["services"] = List(ServiceNames) }),
        ["service_type"] = ("ServiceType", call => new() { ["type"] = ServiceType(call) }),
        ["nodes"] = ("Nodes", _ => new() { ["nodes"] = List([Node]) }),
        ["node_details"] = ("NodeDetails", call => NodeDetails(call, call.Argument("node") == Node)),
        ["get_param_names"] = ("GetParamNames", call => new() { ["names"] = List(call.DescribedRobots.Select(robot => RobotTopic.NameOf(robot, Description))) }),
        ["has_param"] = ("HasParam", call => new() { ["exists"] = Value(call) != null }),
        ["get_param"] = ("GetParam", call => new() { ["value"] = Value(call) ?? call.Argument("default", 1) ?? "null" }),
        ["get_ros_version"] = ("GetROSVersion", call => new() { ["version"] = call.IsRos2 ? 2 : 1, ["distro"] = "" }),
    };

    static readonly string[] ServiceNames = [.. Services.Keys.Select(name => Prefix + name), RosTopics.GetTopics, RosTopics.GetTime];

    static IEnumerable<string> TopicsOf(RosapiCall call) => call.Topics.Select(topic => topic.Key);

    /// <summary>Calls a service and gets the values of its response; null for a service that this class does not provide.</summary>
    /// <param name="service">Name of the service, with its slash.</param>
    /// <param name="text">The complete call, valid JSON.</param>
    /// <param name="isRos2">Whether the caller has used type names of ROS 2.</param>
    public static string Call(string service, ReadOnlyMemory<byte> text, bool isRos2, MessageHub hub)
    {
        if (!service.StartsWith(Prefix, StringComparison.Ordinal) || !Services.TryGetValue(service[Prefix.Length..], out var known)) return null;
        using var call = new RosapiCall(text, isRos2, hub);
        return known.Answer(call).ToJsonString();
    }

    /// <summary>Gets all topics with their types.</summary>
    public static IEnumerable<KeyValuePair<string, string>> Types(bool isRos2, MessageHub hub) =>
        Publications.With(hub.Robots).Select(topic => KeyValuePair.Create(topic.Key, new MessageDefinitions(isRos2).Spelled(topic.Value)));

    static IEnumerable<string> TypesOf(RosapiCall call) => call.Topics.Select(topic => call.Definitions.Spelled(topic.Value));

    static string TypeOf(RosapiCall call, string topic) =>
        call.Topics.FirstOrDefault(one => one.Key == topic).Value is { } type ? call.Definitions.Spelled(type) : "";

    static string ServiceType(RosapiCall call)
    {
        var name = call.Argument("service") ?? "";
        if (name == RosTopics.GetTime) return call.ServicePackage + "GetTime";
        if (name == RosTopics.GetTopics) return call.ServicePackage + "Topics";
        return name.StartsWith(Prefix, StringComparison.Ordinal) && Services.TryGetValue(name[Prefix.Length..], out var known)
            ? call.ServicePackage + known.Type : "";
    }

    static JsonObject NodeDetails(RosapiCall call, bool isKnown) => new()
    {
        ["subscribing"] = List(isKnown ? TopicsOf(call).Where(topic => PublishRights.IsOpen(RobotTopic.Parse(topic))) : []),
        ["publishing"] = List(isKnown ? TopicsOf(call) : []),
        ["services"] = List(isKnown ? ServiceNames : []),
    };

    // Returns a parameter as JSON text, as rosapi does.
    static string Value(RosapiCall call)
    {
        var topic = RobotTopic.Parse("/" + call.Argument("name")?.Split(':')[^1].TrimStart('/'));
        return topic.Kind == Description && call.DescriptionOf(topic.Robot) is { } urdf ? JsonSerializer.Serialize(urdf) : null;
    }

    static JsonArray List(IEnumerable<string> items) => new([.. items.Select(item => JsonValue.Create(item))]);
}
