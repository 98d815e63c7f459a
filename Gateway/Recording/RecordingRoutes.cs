using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;

namespace Nowpose.Gateway.Recording;

/// <summary>POST /operations/recording: {"on": "true"} or {"on": "false"}. For operators.</summary>
sealed class RecordingRoutes(Recorder recorder, Door door)
{
    const string Path = "/operations/recording";

    /// <summary>Answers its own requests and hands on the others, WebSockets on every path.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Request.Path != Path || context.Request.Headers.Upgrade.Count > 0) return next(context);
        return HttpMethods.IsPost(context.Request.Method) ? SwitchAsync(context) : Door.RefuseMethodAsync(context, "POST");
    }

    async Task SwitchAsync(HttpContext context)
    {
        if (!await door.AdmitOperatorAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.GetValueOrDefault("on") is not ("true" or "false"))
        {
            await Door.AnswerAsync(context, StatusCodes.Status400BadRequest, "on: \"true\" or \"false\" is needed");
            return;
        }

        try
        {
            if (request["on"] == "true") recorder.SwitchOn();
            else await recorder.SwitchOffAsync();
            await SmallJson.AnswerAsync(context, recorder.Status, StatusRoutes.Snake);
        }
        catch (InputException fault)
        {
            await Door.AnswerAsync(context, StatusCodes.Status409Conflict, fault.Message);
        }
    }
}
