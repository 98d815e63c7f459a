using System.Globalization;
using Nowpose.Gateway.Operations;

namespace Nowpose.Gateway.Security;

/// <summary>Lets requests in as the protocol says, and answers those it does not. One for all that a gateway serves.</summary>
sealed class Door(GatewayOptions options, WrongTokens wrong, ConnectionCounters counters, Action<string> log)
{
    public BrowserSessions Sessions { get; } = new(options.Time);

    AccessRule Rule => field ??= new AccessRule(options, Sessions);

    /// <summary>The role of whoever asks; null when the request was refused, and answered.</summary>
    public async Task<Role?> AdmitAsync(HttpContext context)
    {
        if (!await AdmitOriginAsync(context)) return null;
        if (Rule.RoleOf(context) is { } role) return role;
        await RefuseTokenAsync(context);
        return null;
    }

    /// <summary>Whether it is not another site's page that asks; when it is, the request was refused, and answered.</summary>
    public async Task<bool> AdmitOriginAsync(HttpContext context)
    {
        if (Rule.IsOriginAllowed(context)) return true;
        await RefuseAsync(context, StatusCodes.Status403Forbidden, Closure.Origin,
            $"the Origin is not the gateway's own; allowed are {Rule.AllowedOrigins(context)}");
        return false;
    }

    /// <summary>Whether the one who asks may switch and pair; when not, the request was refused, and answered.</summary>
    public async Task<bool> AdmitOperatorAsync(HttpContext context)
    {
        if (await AdmitAsync(context) == null) return false;
        if (IsOperator(context)) return true;
        await AnswerAsync(context, StatusCodes.Status403Forbidden,
            "this is for the role operator; log in with a token of a line \"operator TOKEN\", or ask on the gateway's own machine where there are none");
        return false;
    }

    /// <inheritdoc cref="AccessRule.IsOperator"/>
    public bool IsOperator(HttpContext context) => Rule.IsOperator(context);

    /// <inheritdoc cref="AccessRule.TokenHashOf"/>
    public byte[] TokenHashOf(HttpContext context) => Rule.TokenHashOf(context);

    /// <inheritdoc cref="AccessRule.LoginOf"/>
    public Func<bool> LoginOf(HttpContext context) => Rule.LoginOf(context);

    /// <summary>Whether no page whose name was made to point here (DNS rebinding) can be asking: it has no token, where one is asked for.</summary>
    public bool IsNoRebinding(HttpContext context) => options.AsksForTokens || IsOwnHost(context);

    /// <inheritdoc cref="AccessRule.IsOwnHost"/>
    public bool IsOwnHost(HttpContext context) => Rule.IsOwnHost(context);

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

    /// <summary>For requests that may be made again after a while.</summary>
    public static Task RefuseForNowAsync(HttpContext context, TimeSpan wait, string text)
    {
        context.Response.Headers.RetryAfter = Math.Ceiling(wait.TotalSeconds).ToString(CultureInfo.InvariantCulture);
        return AnswerAsync(context, StatusCodes.Status429TooManyRequests, text);
    }

    // A known token is let in before this, also from an address that others guess from.
    async Task RefuseTokenAsync(HttpContext context)
    {
        const string Text = "no or an unknown bearer token";
        var address = context.Connection.RemoteIpAddress;
        var blocked = wrong.BlockedFor(address);
        var wait = AccessRule.HasBearer(context) ? wrong.Count(address, options.WrongTokenDelay) : TimeSpan.Zero;
        if (blocked == TimeSpan.Zero || !AccessRule.HasBearer(context))
        {
            await RefuseAsync(context, StatusCodes.Status401Unauthorized, Closure.Token, Text);
            return;
        }

        counters.Count(Closure.Token);
        log("websocket: refused a connection, too many wrong tokens of its address");
        // Also when the client goes away: its place as a pending connection is taken until then.
        await Task.Delay(wait, options.Time);
        await RefuseForNowAsync(context, blocked, $"{Text}, and too many of them from this address");
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
