namespace Nowpose.Gateway.Security;

/// <summary>Lets requests in as the protocol says, and answers those it does not.</summary>
sealed class Door(GatewayOptions options, ConnectionCounters counters, Action<string> log)
{
    readonly AccessRule _rule = new(options);

    /// <summary>The role of whoever asks; null when the request was refused, and answered.</summary>
    public async Task<Role?> AdmitAsync(HttpContext context)
    {
        if (!await AdmitOriginAsync(context)) return null;
        if (_rule.RoleOf(context) is { } role) return role;
        await RefuseAsync(context, StatusCodes.Status401Unauthorized, Closure.Token, "no or an unknown bearer token");
        return null;
    }

    /// <summary>Whether it is not another site's page that asks; when it is, the request was refused, and answered.</summary>
    public async Task<bool> AdmitOriginAsync(HttpContext context)
    {
        if (_rule.IsOriginAllowed(context)) return true;
        await RefuseAsync(context, StatusCodes.Status403Forbidden, Closure.Origin,
            $"the Origin is not the gateway's own; allowed are {_rule.AllowedOrigins(context)}");
        return false;
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

    /// <summary>For requests of another method than those that are allowed there.</summary>
    public static Task RefuseMethodAsync(HttpContext context, string allowed)
    {
        context.Response.Headers.Allow = allowed;
        return AnswerAsync(context, StatusCodes.Status405MethodNotAllowed, $"{context.Request.Path}: allowed is {allowed}");
    }

    Task RefuseAsync(HttpContext context, int status, Closure why, string text)
    {
        counters.Count(why);
        log($"websocket: refused a connection, {why}");
        if (status == StatusCodes.Status401Unauthorized)
            context.Response.Headers.WWWAuthenticate = "Bearer";
        return AnswerAsync(context, status, text);
    }
}
