namespace Nowpose.Gateway.Security;

/// <summary>Lets requests in as the protocol says, and answers those it does not.</summary>
sealed class Door(GatewayOptions options, ConnectionCounters counters, Action<string> log)
{
    readonly AccessRule _rule = new(options);

    /// <summary>The role of whoever asks; null when the request was refused, and answered.</summary>
    public async Task<Role?> AdmitAsync(HttpContext context)
    {
        if (!_rule.IsOriginAllowed(context))
            return await RefuseAsync(context, StatusCodes.Status403Forbidden, Closure.Origin, "the Origin is not the gateway's own");
        return _rule.RoleOf(context)
            ?? await RefuseAsync(context, StatusCodes.Status401Unauthorized, Closure.Token, "no or an unknown bearer token");
    }

    /// <summary>One line of text, and the end of the connection.</summary>
    public static Task AnswerAsync(HttpContext context, int status, string text)
    {
        context.Response.StatusCode = status;
        // Whoever is not let in must not hold one of the places that are.
        context.Response.Headers.Connection = "close";
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync(text + "\n");
    }

    async Task<Role?> RefuseAsync(HttpContext context, int status, Closure why, string text)
    {
        counters.Count(why);
        log($"websocket: refused a connection, {why}");
        if (status == StatusCodes.Status401Unauthorized)
            context.Response.Headers.WWWAuthenticate = "Bearer";
        await AnswerAsync(context, status, text);
        return null;
    }
}
