using System.Text.Json;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Finds options of a rosbridge request that the gateway does not support and ignores.</summary>
static class Unsupported
{
    /// <summary>Gets one warning for the client for each unsupported option of the request.</summary>
    /// <param name="text">The complete request, valid JSON.</param>
    public static IReadOnlyList<string> In(ReadOnlyMemory<byte> text)
    {
        try
        {
            using var message = JsonDocument.Parse(text);
            return [.. In(message.RootElement)];
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            // The text contains NaN or an unpaired surrogate, which the gateway's own reader accepts in fields that it does not read.
            return [];
        }
    }

    static IEnumerable<string> In(JsonElement root)
    {
        if (root.TryGetProperty("compression", out var compression) && !IsNone(compression))
            yield return RequestMessages.Compression(Short(compression));
        if (root.TryGetProperty("fragment_size", out var size) && size.ValueKind != JsonValueKind.Null)
            yield return RequestMessages.FragmentSize(Short(size));
    }

    static bool IsNone(JsonElement compression) => compression.ValueKind == JsonValueKind.Null
        || (compression.ValueKind == JsonValueKind.String && compression.GetString() is "none" or "");

    static string Short(JsonElement value) => value.ToString() is { Length: <= 32 } text ? text : value.ToString()[..31] + "…";
}
