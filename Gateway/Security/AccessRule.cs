using System.Net;
using Microsoft.Net.Http.Headers;
using Nowpose.Gateway.Operations;

namespace Nowpose.Gateway.Security;

/// <summary>Who may open a WebSocket or ask for a page, and as what.</summary>
/// <param name="sessions">Of browsers, which open pages and WebSockets without a header of ours.</param>
sealed class AccessRule(GatewayOptions options, BrowserSessions sessions)
{
    const string TokenScheme = "Bearer ";

    /// <summary>Whether the request comes from no browser page, or from one of the gateway's own.</summary>
    /// <remarks>
    /// The Host header is not asked: a page whose name was made to point here (DNS rebinding) sends its own there. A page
    /// of the gateway's was loaded from the address this connection has.
    /// </remarks>
    public bool IsOriginAllowed(HttpContext context)
    {
        var origins = context.Request.Headers.Origin;
        if (origins.Count == 0)
            return true;
        return origins.Count == 1 && Uri.TryCreate(origins[0], UriKind.Absolute, out var origin)
            && origin.Scheme == Scheme
            && origin.Port == context.Connection.LocalPort
            && OwnHosts.Contain(origin, context.Connection.LocalIpAddress);
    }

    /// <summary>What <see cref="IsOriginAllowed"/> accepts, in words: "http://10.0.0.7:47011, http://cell:47011".</summary>
    public string AllowedOrigins(HttpContext context) => string.Join(
        ", ", OwnHosts.Of(context.Connection.LocalIpAddress).Select(host => $"{Scheme}://{host}:{context.Connection.LocalPort}"));

    /// <summary>The role of whoever asks, or null when it has none of the tokens asked for.</summary>
    /// <remarks>Where none are asked for, an adapter of the gateway's still shows its own: bound to one address, it comes from there.</remarks>
    public Role? RoleOf(HttpContext context)
    {
        var known = TokenHashOf(context) is { } hash ? options.RoleOf(hash) : null;
        if (known != null || options.AsksForTokens)
            return known;
        return IsFromHere(context) ? Role.Source : Role.Observer;
    }

    /// <summary>Whether the one who asks may switch the recorder and pair headsets.</summary>
    public bool IsOperator(HttpContext context) => options.AsksForTokens ? RoleOf(context) == Role.Operator : IsFromHere(context);

    /// <summary>Of the token in the request's header, or the one its browser logged in with; null without. Known or not.</summary>
    public byte[] TokenHashOf(HttpContext context)
    {
        var values = context.Request.Headers[HeaderNames.Authorization];
        if (values.Count == 0)
            return SessionOf(context) is { } id ? sessions.TokenHashOf(id) : null;
        var value = values.Count == 1 ? values[0] : "";
        return value.StartsWith(TokenScheme, StringComparison.OrdinalIgnoreCase) ? TokenList.HashOf(value[TokenScheme.Length..].Trim()) : null;
    }

    /// <summary>Whether the request shows a token in its header.</summary>
    public static bool HasBearer(HttpContext context) => context.Request.Headers[HeaderNames.Authorization].Count > 0;

    /// <summary>Whether the login that let a request in still counts, from now on; null for one that was let in without.</summary>
    public Func<bool> LoginOf(HttpContext context) =>
        options.AsksForTokens && context.Request.Headers[HeaderNames.Authorization].Count == 0 && SessionOf(context) is { } id
            ? () => sessions.IsOpen(id) : null;

    /// <summary>Whether the address asked for is one of the gateway's own: not a name that was made to point here (DNS rebinding).</summary>
    public bool IsOwnHost(HttpContext context) =>
        Uri.TryCreate($"{Scheme}://{context.Request.Host.Value}", UriKind.Absolute, out var uri)
        && OwnHosts.Contain(uri, context.Connection.LocalIpAddress);

    static string SessionOf(HttpContext context) => context.Request.Cookies[BrowserSessions.CookieOf(context)];

    string Scheme => options.Certificate == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps;

    static bool IsFromHere(HttpContext context) =>
        context.Connection.RemoteIpAddress is { } remote && IPAddress.IsLoopback(remote);
}
