using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;

namespace Nowpose.Gateway.Recording;

/// <summary>Enables and disables the recorder, lists the recordings and sends them. For operators.</summary>
/// <remarks>
/// POST /operations/recording with {"on": "true"} or {"on": "false"}. GET /operations/recordings for the list; with a name appended for a file.
/// </remarks>
sealed class RecordingRoutes(Recorder recorder, RecordingsFolder folder, AccessControl accessControl)
{
    const string SwitchPath = "/operations/recording", ListPath = "/operations/recordings", FilePath = ListPath + "/";

    /// <summary>Answers its own requests and passes on all others, including WebSockets on any path.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        if (context.Request.Headers.Upgrade.Count > 0) return next(context);
        var (path, method) = (context.Request.Path.Value ?? "", context.Request.Method);
        if (path == SwitchPath) return HttpMethods.IsPost(method) ? SwitchAsync(context) : AccessControl.RefuseMethodAsync(context, "POST");
        if (path != ListPath && !path.StartsWith(FilePath, StringComparison.Ordinal)) return next(context);
        if (!HttpMethods.IsGet(method)) return AccessControl.RefuseMethodAsync(context, "GET");
        return path == ListPath ? ListAsync(context) : SendAsync(context, path[FilePath.Length..]);
    }

    async Task SwitchAsync(HttpContext context)
    {
        if (!await accessControl.AdmitOperatorAsync(context) || await SmallJson.ReadAsync(context) is not { } request) return;
        if (request.GetValueOrDefault("on") is not ("true" or "false"))
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status400BadRequest, RecorderMessages.OnField);
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
            await AccessControl.AnswerAsync(context, StatusCodes.Status409Conflict, fault.Message);
        }
    }

    async Task ListAsync(HttpContext context)
    {
        if (!await AdmitReaderAsync(context)) return;
        await SmallJson.AnswerAsync(context, folder.List(), StatusRoutes.Snake);
    }

    async Task SendAsync(HttpContext context, string name)
    {
        if (!await AdmitReaderAsync(context)) return;
        if (folder.Find(name) is not { } file)
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status404NotFound, RecorderMessages.UnknownName);
            return;
        }

        var response = context.Response;
        response.ContentType = "application/jsonl";
        response.Headers.ContentDisposition = $"attachment; filename=\"{file.Name}\"";
        response.Headers.CacheControl = "no-store";
        response.Headers.Connection = "close";
        // Data that the recorder appends from now on are not sent.
        response.ContentLength = file.Length;
        await response.SendFileAsync(file.FullName, 0, file.Length, context.RequestAborted);
    }

    // Browsers send no Origin header when a page requests from its own host.
    async Task<bool> AdmitReaderAsync(HttpContext context)
    {
        if (accessControl.IsNoRebinding(context)) return await accessControl.AdmitOperatorAsync(context);
        await AccessControl.AnswerAsync(context, StatusCodes.Status403Forbidden, OperationsMessages.UseOwnAddress);
        return false;
    }
}
