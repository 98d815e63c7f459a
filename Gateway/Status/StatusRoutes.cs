using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Status;

/// <summary>What the gateway answers to those who watch it: a page, a Prometheus, and whoever starts it.</summary>
sealed class StatusRoutes(GatewayOptions options, GatewayStatus status, Door door)
{
    const string StatePath = "/operations/state", MetricsPath = "/metrics", LivePath = "/healthz", ReadyPath = "/readyz";

    internal static readonly JsonSerializerOptions Snake = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
        DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
        Converters = { new FiniteNumbers() },
    };

    /// <summary>Answers its own requests and hands on the others, WebSockets on every path.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Request.Headers.Upgrade.Count > 0) return next(context);
        return context.Request.Path.Value switch
        {
            StatePath => AnswerAsync(context, TellStateAsync),
            MetricsPath => AnswerAsync(context, TellMetricsAsync),
            // Whoever starts it has no token, and is told nothing but the word.
            LivePath => AnswerAsync(context, _ => SendAsync(context, "text/plain", "live\n"u8.ToArray())),
            ReadyPath => AnswerAsync(context, TellReadyAsync),
            _ => next(context),
        };
    }

    static Task AnswerAsync(HttpContext context, Func<HttpContext, Task> answer) =>
        HttpMethods.IsGet(context.Request.Method) || HttpMethods.IsHead(context.Request.Method) ? answer(context) : Door.RefuseMethodAsync(context, "GET");

    async Task TellStateAsync(HttpContext context)
    {
        if (await AdmitAsync(context) is not { } role) return;
        // On the gateway's own machine, where no tokens are asked for, everybody is one.
        var effective = door.IsOperator(context) ? Role.Operator : role;
        var state = status.Read() with { Role = effective.ToString().ToLowerInvariant() };
        await SendAsync(context, "application/json", JsonSerializer.SerializeToUtf8Bytes(state, Snake));
    }

    async Task TellMetricsAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return;
        await SendAsync(context, PrometheusText.ContentType, Encoding.UTF8.GetBytes(Metrics.Of(status.Read(), status.Forwarding)));
    }

    Task TellReadyAsync(HttpContext context)
    {
        // Headsets refuse one that has expired.
        var isReady = status.IsReady && !(options.Certificate?.NotAfter < DateTime.Now);
        context.Response.StatusCode = isReady ? StatusCodes.Status200OK : StatusCodes.Status503ServiceUnavailable;
        return SendAsync(context, "text/plain", isReady ? "ready\n"u8.ToArray() : "waiting\n"u8.ToArray());
    }

    async Task<Role?> AdmitAsync(HttpContext context)
    {
        // Browsers name no origin when a page asks its own host.
        if (door.IsNoRebinding(context)) return await door.AdmitAsync(context);
        await Door.AnswerAsync(context, StatusCodes.Status403Forbidden, "ask by the gateway's address, its name or localhost");
        return null;
    }

    static Task SendAsync(HttpContext context, string type, byte[] content)
    {
        var response = context.Response;
        response.ContentType = type;
        response.ContentLength = content.Length;
        response.Headers.CacheControl = "no-store";
        // It must not hold one of the places of those that connect.
        response.Headers.Connection = "close";
        return HttpMethods.IsHead(context.Request.Method) ? Task.CompletedTask : response.Body.WriteAsync(content).AsTask();
    }
}
