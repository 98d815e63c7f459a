using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Prometheus;

namespace Nowpose.Gateway.Status;

/// <summary>Serves the status of the gateway to the operations page, to Prometheus and to service managers.</summary>
sealed class StatusRoutes(GatewayStatus status, AccessControl accessControl)
{
    const string StatePath = "/operations/state", MetricsPath = "/metrics", LivePath = "/healthz", ReadyPath = "/readyz",
        EventsPath = "/operations/events";

    // Maximum number of lines of /readyz.
    const int MaxReasons = 64;

    internal static readonly JsonSerializerOptions Snake = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower,
        DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
        Converters = { new FiniteNumbers() },
    };

    readonly SharedResult<StatusSnapshot> _state = new(status.Read);
    readonly SharedResult<IReadOnlyList<string>> _notReadyReasons = new(status.NotReadyReasons);

    /// <summary>Handles requests for the status. Passes on all others, including WebSocket requests on these paths.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Request.Headers.Upgrade.Count > 0) return next(context);
        return context.Request.Path.Value switch
        {
            StatePath => AnswerAsync(context, AnswerStateAsync),
            MetricsPath => AnswerAsync(context, AnswerMetricsAsync),
            EventsPath => AnswerAsync(context, AnswerEventsAsync),
            // /healthz and /readyz require no token, because their responses contain only reasons with names, for example of joints.
            LivePath => AnswerAsync(context, _ => SendAsync(context, "text/plain", "live\n"u8.ToArray())),
            ReadyPath => AnswerAsync(context, AnswerReadyAsync),
            _ => next(context),
        };
    }

    static Task AnswerAsync(HttpContext context, Func<HttpContext, Task> answer) =>
        HttpMethods.IsGet(context.Request.Method) || HttpMethods.IsHead(context.Request.Method) ? answer(context) : AccessControl.RefuseMethodAsync(context, "GET");

    async Task AnswerStateAsync(HttpContext context)
    {
        if (await AdmitAsync(context) is not { } role) return;
        // If no token is required, every client on the gateway's machine is an operator.
        var effective = accessControl.IsOperator(context) ? Role.Operator : role;
        var state = await _state.GetAsync() with
        {
            Role = effective.ToString().ToLowerInvariant(),
            IsLoggedIn = accessControl.LoginOf(context) != null,
        };
        await SendAsync(context, "application/json", JsonSerializer.SerializeToUtf8Bytes(state, Snake));
    }

    async Task AnswerMetricsAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return;
        await SendAsync(context, PrometheusText.ContentType, Encoding.UTF8.GetBytes(Metrics.Of(await _state.GetAsync(), status.Forwarding)));
    }

    async Task AnswerEventsAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return;
        var events = status.Events.Read().Select(one => one.View).ToList();
        var format = context.Request.Query["format"].ToString();
        if (format is not ("" or "json" or "csv"))
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status400BadRequest, OperationsMessages.Format);
            return;
        }

        context.Response.Headers.ContentDisposition = $"attachment; filename=\"nowpose-events.{(format == "csv" ? "csv" : "json")}\"";
        if (format == "csv") await SendAsync(context, "text/csv; charset=utf-8", Encoding.UTF8.GetBytes(EventText.Csv(events)));
        else await SendAsync(context, "application/json", JsonSerializer.SerializeToUtf8Bytes(events, Snake));
    }

    async Task AnswerReadyAsync(HttpContext context)
    {
        var reasons = await _notReadyReasons.GetAsync();
        context.Response.StatusCode = reasons.Count == 0 ? StatusCodes.Status200OK : StatusCodes.Status503ServiceUnavailable;
        var lines = reasons.Take(MaxReasons).Prepend(reasons.Count == 0 ? "ready" : "waiting").ToList();
        if (reasons.Count > MaxReasons) lines.Add($"and {reasons.Count - MaxReasons} more");
        await SendAsync(context, "text/plain; charset=utf-8", Encoding.UTF8.GetBytes(string.Join('\n', lines) + "\n"));
    }

    async Task<Role?> AdmitAsync(HttpContext context)
    {
        // Checks the host name, because browsers send no Origin header with a GET request of a page to its own host.
        if (accessControl.IsNoRebinding(context)) return await accessControl.AdmitAsync(context);
        await AccessControl.AnswerAsync(context, StatusCodes.Status403Forbidden, OperationsMessages.UseOwnAddress);
        return null;
    }

    static Task SendAsync(HttpContext context, string type, byte[] content)
    {
        var response = context.Response;
        response.ContentType = type;
        response.ContentLength = content.Length;
        response.Headers.CacheControl = "no-store";
        // Closes the connection, so that it does not reduce the number of connections for other clients.
        response.Headers.Connection = "close";
        return HttpMethods.IsHead(context.Request.Method) ? Task.CompletedTask : response.Body.WriteAsync(content).AsTask();
    }
}
