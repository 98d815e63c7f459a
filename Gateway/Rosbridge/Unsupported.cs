using System.Text.Json;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Finds options of rosbridge requests that the gateway does not support. The request is served without them.</summary>
static class Unsupported
{
    /// <summary>Gets the warning to the client; null if there are no unsupported options.</summary>
    /// <param name="text">A whole message, valid JSON.</param>
    public static string In(ReadOnlyMemory<byte> text)
    {
        try
        {
            using var message = JsonDocument.Parse(text);
            return In(message.RootElement);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // NaN or an unpaired surrogate, which the gateway's own reader accepts in a field that it does not read.
            return null;
        }
    }

    static string In(JsonElement root)
    {
        if (root.TryGetProperty("compression", out var compression) && !IsNone(compression))
            return RequestMessages.Compression(Short(compression));
        return root.TryGetProperty("fragment_size", out var size) && size.ValueKind != JsonValueKind.Null
            ? RequestMessages.FragmentSize(Short(size)) : null;
    }

    static bool IsNone(JsonElement compression) => compression.ValueKind == JsonValueKind.Null
        || (compression.ValueKind == JsonValueKind.String && compression.GetString() is "none" or "");

    static string Short(JsonElement value) => value.ToString() is { Length: <= 32 } text ? text : value.ToString()[..31] + "…";
}
