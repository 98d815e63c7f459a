using System.Text.Json;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Finds options of a rosbridge request that the gateway does not support and ignores.</summary>
static class Unsupported
{
    /// <summary>Gets the warning for the client; null if the request has no unsupported option.</summary>
    /// <param name="text">The complete request, valid JSON.</param>
    public static string In(ReadOnlyMemory<byte> text)
    {
        try
        {
            using var message = JsonDocument.Parse(text);
            return In(message.RootElement);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // The text contains NaN or an unpaired surrogate, which the gateway's own reader accepts in fields that it does not read.
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
