using System.Text.Json;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>A call of a rosapi service.</summary>
sealed class RosapiCall : IDisposable
{
    readonly JsonDocument _text;
    readonly MessageHub _hub;

    public RosapiCall(ReadOnlyMemory<byte> text, bool isRos2, MessageHub hub)
    {
        _text = Parsed(text);
        _hub = hub;
        IsRos2 = isRos2 || Text(_text.RootElement, "type")?.Contains("/srv/", StringComparison.Ordinal) == true;
        Definitions = new MessageDefinitions(IsRos2);
    }

    public bool IsRos2 { get; }

    public MessageDefinitions Definitions { get; }

    public string ServicePackage => IsRos2 ? "rosapi_msgs/srv/" : "rosapi/";

    /// <summary>All topics with their types, in ROS 1 names.</summary>
    public IEnumerable<KeyValuePair<string, string>> Topics => Publications.With(_hub.Robots);

    /// <summary>Namespaces of the robots that have a description. The empty string stands for the robot without a namespace.</summary>
    public IEnumerable<string> DescribedRobots => _hub.Robots.Prepend("").Where(robot => DescriptionOf(robot) != null);

    /// <summary>Gets the description of a robot; null if there is none.</summary>
    public string DescriptionOf(string robot) => _hub.DescriptionOf(robot);

    /// <summary>Gets a string argument; null if it is missing.</summary>
    /// <param name="position">Index of the argument among the fields of the request, for arguments without names, which rosbridge accepts.</param>
    public string Argument(string name, int position = 0) =>
        _text.RootElement.TryGetProperty("args", out var args) ? Text(args, name, position) : null;

    public void Dispose() => _text.Dispose();

    // Treats invalid JSON as a call without arguments: the gateway's own reader accepts NaN in fields that it does not read.
    static JsonDocument Parsed(ReadOnlyMemory<byte> text)
    {
        try
        {
            return JsonDocument.Parse(text);
        }
        catch (JsonException)
        {
            return JsonDocument.Parse("{}");
        }
    }

    static string Text(JsonElement element, string name, int position = 0)
    {
        try
        {
            var value = element.ValueKind switch
            {
                JsonValueKind.Object when element.TryGetProperty(name, out var named) => named,
                JsonValueKind.Array when position < element.GetArrayLength() => element[position],
                _ => default,
            };
            return value.ValueKind == JsonValueKind.String ? value.GetString() : null;
        }
        catch (InvalidOperationException)
        {
            // The text contains an unpaired surrogate.
            return null;
        }
    }
}
