using System.Text.Json;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>
/// Reads small requests that are JSON objects of strings, and writes responses as JSON. Checks the size of a request before reading it.
/// </summary>
static class SmallJson
{
    static readonly JsonDocumentOptions Strict = new() { MaxDepth = 2 };

    /// <summary>Reads a request. If it is not a small JSON object of strings, rejects it with an error response.</summary>
    /// <returns>The fields of the object, including unknown fields; null if the request was refused.</returns>
    public static async Task<Dictionary<string, string>> ReadAsync(HttpContext context)
    {
        var length = context.Request.ContentLength;
        if (length > PairingLimits.BodyBytes)
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status413PayloadTooLarge, LimitMessages.BodyBytes(PairingLimits.BodyBytes));
            return null;
        }

        if (length is > 0 && await BodyAsync(context, (int)length) is { } texts) return texts;
        await AccessControl.AnswerAsync(context, StatusCodes.Status400BadRequest, PairingServiceMessages.NotJson);
        return null;
    }

    public static Task AnswerAsync(HttpContext context, object answer, JsonSerializerOptions options = null) =>
        AccessControl.SendAsync(context, "application/json", JsonSerializer.SerializeToUtf8Bytes(answer, options));

    static async Task<Dictionary<string, string>> BodyAsync(HttpContext context, int length)
    {
        var body = new byte[length];
        try
        {
            await context.Request.Body.ReadExactlyAsync(body, context.RequestAborted);
            using var json = JsonDocument.Parse(body, Strict);
            var texts = new Dictionary<string, string>();
            foreach (var field in json.RootElement.EnumerateObject())
                if (field.Value.ValueKind != JsonValueKind.String || !texts.TryAdd(field.Name, field.Value.GetString())) return null;
            return texts;
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException or IOException or BadHttpRequestException)
        {
            return null;
        }
    }
}
