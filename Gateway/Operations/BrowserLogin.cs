using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Operations;

/// <summary>Exchanges a token for a session cookie, and ends the session.</summary>
/// <remarks>Scripts and other sites cannot read the cookie. With TLS, it is sent over TLS only. It is valid as long as its token.</remarks>
sealed class BrowserLogin(GatewayOptions options, Door door, ConnectionCounters counters, Action<string> log)
{
    readonly WrongTokens _wrong = new(options.Time);

    /// <summary>POST /operations/login: {"token": …}.</summary>
    public async Task LogInAsync(HttpContext context)
    {
        if (await RefuseBlockedAsync(context)) return;
        if (!options.AsksForTokens)
            await RefuseAsync(context, StatusCodes.Status400BadRequest, "this gateway requires no token");
        // The address may have been blocked by other requests while the body was being received.
        else if (await SmallJson.ReadAsync(context) is not { } request || await RefuseBlockedAsync(context))
            return;
        else if (options.RoleOf(request.GetValueOrDefault("token", "").Trim()) is { } role)
            await WelcomeAsync(context, request["token"].Trim(), role);
        else
        {
            _wrong.Count(context.Connection.RemoteIpAddress);
            counters.Count(Closure.Token);
            log("operations: refused an unknown token");
            await RefuseAsync(context, StatusCodes.Status401Unauthorized, "not a token of this gateway");
        }
    }

    /// <summary>POST /operations/logout.</summary>
    public Task LogOutAsync(HttpContext context)
    {
        Forget(context);
        context.Response.Cookies.Delete(BrowserSessions.CookieOf(context), Terms());
        return SmallJson.AnswerAsync(context, new { });
    }

    Task<bool> RefuseBlockedAsync(HttpContext context) =>
        Door.RefuseBlockedAsync(context, _wrong, "too many wrong tokens; wait a minute");

    Task WelcomeAsync(HttpContext context, string token, Role role)
    {
        Forget(context);
        context.Response.Cookies.Append(BrowserSessions.CookieOf(context), door.Sessions.Open(TokenList.HashOf(token)), Terms());
        log($"operations: a browser logged in as {role}");
        return SmallJson.AnswerAsync(context, new { role = role.ToString().ToLowerInvariant() });
    }

    void Forget(HttpContext context)
    {
        if (context.Request.Cookies[BrowserSessions.CookieOf(context)] is { } id) door.Sessions.Close(id);
    }

    CookieOptions Terms() => new() { HttpOnly = true, SameSite = SameSiteMode.Strict, Secure = options.Certificate != null, Path = "/" };

    static Task RefuseAsync(HttpContext context, int status, string text) => Door.AnswerAsync(context, status, text);
}
