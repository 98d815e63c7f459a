using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>Logs browsers in and out: sets a session cookie in exchange for a token, and ends the session.</summary>
/// <remarks>
/// Scripts and other sites cannot read the cookie. With TLS, browsers send it over TLS only. The session ends when its token is revoked.
/// </remarks>
sealed class BrowserLogin(GatewayOptions options, AccessControl accessControl, ConnectionCounters counters)
{
    readonly WrongTokens _wrong = new(options.Time);

    /// <summary>Handles POST /operations/login, whose body is {"token": …}.</summary>
    public async Task LogInAsync(HttpContext context)
    {
        if (await RefuseBlockedAsync(context)) return;
        if (!options.AsksForTokens)
            await RefuseAsync(context, StatusCodes.Status400BadRequest, OperationsMessages.NoTokenNeeded);
        // Checks again after the body is received, because other requests may have blocked the address in the meantime.
        else if (await SmallJson.ReadAsync(context) is not { } request || await RefuseBlockedAsync(context))
            return;
        else if (options.RoleOf(request.GetValueOrDefault("token", "").Trim()) is { } role)
            await OpenSessionAsync(context, request["token"].Trim(), role);
        else
        {
            _wrong.Count(context.Connection.RemoteIpAddress);
            counters.Count(Closure.Token);
            accessControl.Log(context, OperationsMessages.UnknownTokenLog, role: null, hash: null);
            await RefuseAsync(context, StatusCodes.Status401Unauthorized, OperationsMessages.UnknownToken);
        }
    }

    /// <summary>Handles POST /operations/logout.</summary>
    public Task LogOutAsync(HttpContext context)
    {
        CloseSession(context);
        context.Response.Cookies.Delete(BrowserSessions.CookieOf(context), CookieSettings());
        return SmallJson.AnswerAsync(context, new { });
    }

    Task<bool> RefuseBlockedAsync(HttpContext context) =>
        accessControl.RefuseBlockedAsync(context, _wrong, OperationsMessages.TooManyWrong);

    Task OpenSessionAsync(HttpContext context, string token, Role role)
    {
        CloseSession(context);
        var hash = TokenList.HashOf(token);
        context.Response.Cookies.Append(BrowserSessions.CookieOf(context), accessControl.Sessions.Open(hash), CookieSettings());
        accessControl.Log(context, OperationsMessages.LoggedIn, role, hash);
        return SmallJson.AnswerAsync(context, new { role = role.ToString().ToLowerInvariant() });
    }

    void CloseSession(HttpContext context)
    {
        if (context.Request.Cookies[BrowserSessions.CookieOf(context)] is { } id) accessControl.Sessions.Close(id);
    }

    CookieOptions CookieSettings() => new() { HttpOnly = true, SameSite = SameSiteMode.Strict, Secure = options.Certificate != null, Path = "/" };

    static Task RefuseAsync(HttpContext context, int status, string text) => AccessControl.AnswerAsync(context, status, text);
}
