using System.Text.Json;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>Reads and writes requests and answers with a few texts. Their size is checked before they are read.</summary>
static class SmallJson
{
    static readonly JsonDocumentOptions Strict = new() { MaxDepth = 2 };

    /// <returns>
    /// The texts of the request's object, including unknown ones; null for any other request, which has then been refused and answered.
    /// </returns>
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

    public static Task AnswerAsync(HttpContext context, object answer, JsonSerializerOptions options = null)
    {
        var bytes = JsonSerializer.SerializeToUtf8Bytes(answer, options);
        context.Response.ContentType = "application/json";
        context.Response.ContentLength = bytes.Length;
        context.Response.Headers.CacheControl = "no-store";
        context.Response.Headers.Connection = "close";
        return context.Response.Body.WriteAsync(bytes).AsTask();
    }

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
