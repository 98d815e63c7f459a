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
        _text = JsonDocument.Parse(text);
        _hub = hub;
        IsRos2 = isRos2 || Text(_text.RootElement, "type")?.Contains("/srv/", StringComparison.Ordinal) == true;
        Definitions = new MessageDefinitions(IsRos2);
    }

    public bool IsRos2 { get; }

    public MessageDefinitions Definitions { get; }

    public string ServicePackage => IsRos2 ? "rosapi_msgs/srv/" : "rosapi/";

    /// <summary>The robot description; null if there is none.</summary>
    public string Description => _hub.Description;

    /// <summary>Gets a text argument; null if it is missing.</summary>
    public string Argument(string name) => _text.RootElement.TryGetProperty("args", out var args) ? Text(args, name) : null;

    public void Dispose() => _text.Dispose();

    static string Text(JsonElement element, string name) =>
        element.ValueKind == JsonValueKind.Object && element.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String
            ? value.GetString() : null;
}
