using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;

namespace Nowpose.Gateway.Recording;

/// <summary>Serves operators' requests to enable and disable the recorder, to list recordings and to download a recording.</summary>
/// <remarks>
/// POST /operations/recording with {"on": "true"} or {"on": "false"} enables or disables the recorder. GET /operations/recordings returns the
/// list, and GET /operations/recordings/NAME a recording.
/// </remarks>
sealed class RecordingRoutes(Recorder recorder, RecordingsFolder folder, AccessControl accessControl)
{
    const string SwitchPath = "/operations/recording", ListPath = "/operations/recordings", FilePath = ListPath + "/";

    /// <summary>Handles requests about recordings. Passes on all others.</summary>
    public Task ServeAsync(HttpContext context, RequestDelegate next)
    {
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
            var isOn = request["on"] == "true";
            if (isOn) recorder.SwitchOn();
            else await recorder.SwitchOffAsync();
            accessControl.Log(context, isOn ? RecorderMessages.Enabled : RecorderMessages.Disabled);
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
        IReadOnlyList<StoredRecording> listed;
        try
        {
            listed = folder.List();
        }
        catch (IOException notRead)
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, notRead.Message);
            return;
        }

        await SmallJson.AnswerAsync(context, listed, StatusRoutes.Snake);
    }

    async Task SendAsync(HttpContext context, string name)
    {
        if (!await AdmitReaderAsync(context)) return;
        if (folder.Find(name) is not { } file)
        {
            await AccessControl.AnswerAsync(context, StatusCodes.Status404NotFound, RecorderMessages.UnknownName);
            return;
        }

        accessControl.Log(context, RecorderMessages.Download, file.Name);
        var response = context.Response;
        response.ContentType = "application/jsonl";
        response.Headers.ContentDisposition = $"attachment; filename=\"{file.Name}\"";
        response.Headers.CacheControl = "no-store";
        response.Headers.Connection = "close";
        // Sends the current length, without the data that the recorder appends during the download.
        response.ContentLength = file.Length;
        await response.SendFileAsync(file.FullName, 0, file.Length, context.RequestAborted);
    }

    // Checks the host name, because browsers send no Origin header with a GET request of a page to its own host.
    async Task<bool> AdmitReaderAsync(HttpContext context)
    {
        if (accessControl.IsNoRebinding(context)) return await accessControl.AdmitOperatorAsync(context);
        await AccessControl.AnswerAsync(context, StatusCodes.Status403Forbidden, OperationsMessages.UseOwnAddress);
        return false;
    }
}
