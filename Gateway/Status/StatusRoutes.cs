using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Nowpose.Gateway.Pairing;
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

    /// <summary>Handles requests for the status. Passes on all others.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next) => context.Request.Path.Value switch
    {
        StatePath => AnswerAsync(context, AnswerStateAsync),
        MetricsPath => AnswerAsync(context, AnswerMetricsAsync),
        EventsPath => AnswerAsync(context, AnswerEventsAsync),
        // /healthz and /readyz require no token, because their responses contain only reasons with names, for example of joints.
        LivePath => AnswerAsync(context, _ => AccessControl.SendAsync(context, "text/plain", "live\n"u8.ToArray())),
        ReadyPath => AnswerAsync(context, AnswerReadyAsync),
        _ => next(context),
    };

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
        await SmallJson.AnswerAsync(context, state, Snake);
    }

    async Task AnswerMetricsAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return;
        var metrics = Metrics.Of(await _state.GetAsync(), status.Forwarding);
        await AccessControl.SendAsync(context, PrometheusText.ContentType, Encoding.UTF8.GetBytes(metrics));
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
        if (format == "csv") await AccessControl.SendAsync(context, "text/csv; charset=utf-8", Encoding.UTF8.GetBytes(EventText.Csv(events)));
        else await SmallJson.AnswerAsync(context, events, Snake);
    }

    async Task AnswerReadyAsync(HttpContext context)
    {
        var reasons = await _notReadyReasons.GetAsync();
        context.Response.StatusCode = reasons.Count == 0 ? StatusCodes.Status200OK : StatusCodes.Status503ServiceUnavailable;
        var lines = reasons.Take(MaxReasons).Prepend(reasons.Count == 0 ? "ready" : "waiting").ToList();
        if (reasons.Count > MaxReasons) lines.Add($"and {reasons.Count - MaxReasons} more");
        await AccessControl.SendAsync(context, "text/plain; charset=utf-8", Encoding.UTF8.GetBytes(string.Join('\n', lines) + "\n"));
    }

    async Task<Role?> AdmitAsync(HttpContext context)
    {
        // Checks the host name, because browsers send no Origin header with a GET request of a page to its own host.
        if (accessControl.IsNoRebinding(context)) return await accessControl.AdmitAsync(context);
        await AccessControl.AnswerAsync(context, StatusCodes.Status403Forbidden, OperationsMessages.UseOwnAddress);
        return null;
    }
}
