using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>Serves the operations page and its login. Other routes below the same path serve the data for the page.</summary>
/// <remarks>The page needs no token, because it contains no data, only the login form.</remarks>
/// <param name="html">The page; null if it was not built.</param>
sealed class OperationsRoutes(GatewayOptions options, AccessControl accessControl, ConnectionCounters counters, string html)
{
    public const string Path = "/operations";
    const string LoginPath = Path + "/login", LogoutPath = Path + "/logout";

    readonly HtmlPage _page = new(html);
    readonly BrowserLogin _login = new(options, accessControl, counters);

    /// <summary>Handles requests for the page and the login. Passes on all others.</summary>
    public async Task ServeAsync(HttpContext context, RequestDelegate next)
    {
        if (!context.Request.Path.StartsWithSegments(Path, StringComparison.Ordinal)) await next(context);
        else if (await AdmitAsync(context)) await AnswerAsync(context, next);
    }

    Task AnswerAsync(HttpContext context, RequestDelegate next) => context.Request.Path.Value switch
    {
        Path when HttpMethods.IsGet(context.Request.Method) => _page.SendAsync(context),
        LoginPath when HttpMethods.IsPost(context.Request.Method) => _login.LogInAsync(context),
        LogoutPath when HttpMethods.IsPost(context.Request.Method) => _login.LogOutAsync(context),
        Path => AccessControl.RefuseMethodAsync(context, "GET"),
        LoginPath or LogoutPath => AccessControl.RefuseMethodAsync(context, "POST"),
        _ => next(context),
    };

    async Task<bool> AdmitAsync(HttpContext context)
    {
        if (!await accessControl.AdmitOriginAsync(context)) return false;
        if (accessControl.IsNoRebinding(context)) return true;
        await AccessControl.AnswerAsync(
            context, StatusCodes.Status403Forbidden,
            OperationsMessages.ThisMachineOnly);
        return false;
    }
}
