using System.Globalization;
using Nowpose.Gateway.Operations;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Admits or rejects requests according to the protocol, and sends the responses. All routes of a gateway share one instance.
/// </summary>
/// <param name="log">Receives each line and its kind, which has a rate limit of its own.</param>
sealed class AccessControl(GatewayOptions options, WrongTokens wrong, ConnectionCounters counters, Action<string, string> log)
{
    public BrowserSessions Sessions { get; } = new(options.Time);

    AccessRule Rule => field ??= new AccessRule(options, Sessions);

    /// <summary>Gets the role of a request. Rejects a request without a valid token or from another origin.</summary>
    /// <returns>The role; null if the request was refused.</returns>
    public async Task<Role?> AdmitAsync(HttpContext context)
    {
        if (!await AdmitOriginAsync(context)) return null;
        if (Rule.RoleOf(context) is { } role) return role;
        await RefuseTokenAsync(context);
        return null;
    }

    /// <summary>Rejects a request from a page of another site.</summary>
    /// <returns>False if the request was refused.</returns>
    public async Task<bool> AdmitOriginAsync(HttpContext context)
    {
        if (Rule.IsOriginAllowed(context)) return true;
        await RefuseAsync(context, StatusCodes.Status403Forbidden, Closure.Origin, AccessMessages.OtherOrigin(Rule.AllowedOrigins(context)));
        return false;
    }

    /// <summary>Checks that a client may control the recorder and pair headsets. If it may not, rejects its request.</summary>
    /// <returns>False if the request was refused.</returns>
    public async Task<bool> AdmitOperatorAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return false;
        if (IsOperator(context)) return true;
        Log(context, AccessMessages.OperatorOnlyLog);
        await AnswerAsync(context, StatusCodes.Status403Forbidden, AccessMessages.OperatorOnly);
        return false;
    }

    /// <inheritdoc cref="AccessRule.IsOperator"/>
    public bool IsOperator(HttpContext context) => Rule.IsOperator(context);

    /// <inheritdoc cref="AccessRule.TokenHashOf"/>
    public byte[] TokenHashOf(HttpContext context) => Rule.TokenHashOf(context);

    /// <inheritdoc cref="AccessRule.LoginOf"/>
    public Func<bool> LoginOf(HttpContext context) => Rule.LoginOf(context);

    /// <summary>
    /// Whether a request cannot come from a page that uses DNS rebinding: its host is one of the gateway's own, or the gateway requires tokens,
    /// which such a page does not have.
    /// </summary>
    public bool IsNoRebinding(HttpContext context) => options.AsksForTokens || IsOwnHost(context);

    /// <inheritdoc cref="AccessRule.IsOwnHost"/>
    public bool IsOwnHost(HttpContext context) => Rule.IsOwnHost(context);

    /// <summary>Logs what a client did or why it was refused, with its address, role and token.</summary>
    /// <param name="line">The line, without text from the client.</param>
    /// <param name="about">Text about a client or its request, which follows the line; null for none.</param>
    public void Log(HttpContext context, string line, string about = null) =>
        Log(context, line, Rule.RoleOf(context), TokenHashOf(context), about);

    /// <inheritdoc cref="Log(HttpContext, string, string)"/>
    /// <param name="hash">Hash of the client's token; null if it has none.</param>
    public void Log(HttpContext context, string line, Role? role, byte[] hash, string about = null) =>
        log(AccessMessages.By(line + about, context.Connection.RemoteIpAddress, role, options.LoggedHash(hash)), line);

    /// <summary>Responds with content that browsers must not store, and ends the connection.</summary>
    public static Task SendAsync(HttpContext context, string type, byte[] content)
    {
        var response = context.Response;
        response.ContentType = type;
        response.ContentLength = content.Length;
        response.Headers.CacheControl = "no-store";
        // Closes the connection, so that it does not reduce the number of connections for other clients.
        response.Headers.Connection = "close";
        return HttpMethods.IsHead(context.Request.Method) ? Task.CompletedTask : response.Body.WriteAsync(content).AsTask();
    }

    /// <summary>Responds with one line of text and ends the connection.</summary>
    public static Task AnswerAsync(HttpContext context, int status, string text)
    {
        context.Response.StatusCode = status;
        // Closes the connection, so that a refused client does not keep a connection that an admitted client needs.
        context.Response.Headers.Connection = "close";
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync(text + "\n");
    }

    /// <summary>Refuses a request whose HTTP method is not allowed.</summary>
    public static Task RefuseMethodAsync(HttpContext context, string allowed)
    {
        context.Response.Headers.Allow = allowed;
        return AnswerAsync(context, StatusCodes.Status405MethodNotAllowed, AccessMessages.Method(context.Request.Path, allowed));
    }

    /// <summary>Refuses a request that the client may repeat after a wait.</summary>
    public static Task RefuseForNowAsync(HttpContext context, TimeSpan wait, string text, int status = StatusCodes.Status429TooManyRequests)
    {
        context.Response.Headers.RetryAfter = Math.Ceiling(wait.TotalSeconds).ToString(CultureInfo.InvariantCulture);
        return AnswerAsync(context, status, text);
    }

    /// <summary>Refuses a connection beyond the maximum number, which the caller has counted.</summary>
    /// <param name="why">The limit.</param>
    /// <param name="text">The limit with its value, and what the user can do.</param>
    public Task RefuseExcessAsync(HttpContext context, Closure why, string text)
    {
        Log(context, AccessMessages.Refused(why));
        return AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, text);
    }

    /// <summary>Rejects a request from an address that has sent too many wrong tokens or codes.</summary>
    /// <returns>True if the request was refused.</returns>
    public async Task<bool> RefuseBlockedAsync(HttpContext context, WrongTokens wrongOfForm, string text)
    {
        var blocked = wrongOfForm.BlockedFor(context.Connection.RemoteIpAddress);
        if (blocked == TimeSpan.Zero) return false;
        Log(context, AccessMessages.BlockedLog, role: null, hash: null);
        await RefuseForNowAsync(context, blocked, text);
        return true;
    }

    // Called only for invalid tokens: a valid token is accepted even from a blocked address.
    async Task RefuseTokenAsync(HttpContext context)
    {
        var address = context.Connection.RemoteIpAddress;
        if (!AccessRule.HasBearer(context) || !wrong.Count(address))
        {
            await RefuseAsync(context, StatusCodes.Status401Unauthorized, Closure.Token, AccessMessages.Token);
            return;
        }

        var blocked = wrong.BlockedFor(address);
        counters.Count(Closure.Token);
        Log(context, AccessMessages.TooManyWrongLog);
        // Waits even if the client disconnects, so that its connection counts as pending in the meantime.
        await Task.Delay(options.WrongTokenDelay, options.Time);
        // Responds with 401 instead of 429, so that a client can always report that its token is wrong.
        context.Response.Headers.WWWAuthenticate = "Bearer";
        await RefuseForNowAsync(context, blocked, AccessMessages.TooManyWrong(AccessMessages.Token), StatusCodes.Status401Unauthorized);
    }

    Task RefuseAsync(HttpContext context, int status, Closure why, string text)
    {
        counters.Count(why);
        Log(context, AccessMessages.Refused(why));
        if (status == StatusCodes.Status401Unauthorized)
            context.Response.Headers.WWWAuthenticate = "Bearer";
        return AnswerAsync(context, status, text);
    }
}
