using System.Net;
using Microsoft.Net.Http.Headers;
using Nowpose.Gateway.Operations;

namespace Nowpose.Gateway.Security;

/// <summary>Decides whether a client may open a WebSocket or request a page, and which role it has.</summary>
/// <param name="sessions">Sessions of browsers, which cannot send an Authorization header when they open pages and WebSockets.</param>
sealed class AccessRule(GatewayOptions options, BrowserSessions sessions)
{
    const string TokenScheme = "Bearer ";

    /// <summary>Whether a request comes from one of the gateway's own pages, or from a client that is not a browser page.</summary>
    /// <remarks>
    /// Compares the Origin header with the local address of the connection, from which the gateway's own pages are loaded, and not with the
    /// Host header: with DNS rebinding, a page of another site sends its own host name in both headers.
    /// </remarks>
    public bool IsOriginAllowed(HttpContext context)
    {
        var origins = context.Request.Headers.Origin;
        if (origins.Count == 0)
            return true;
        return origins.Count == 1 && Uri.TryCreate(origins[0], UriKind.Absolute, out var origin)
            && origin.Scheme == Scheme
            && origin.Port == context.Connection.LocalPort
            && OwnHosts.Contain(origin, context.Connection.LocalIpAddress, options.HostNames);
    }

    /// <summary>Gets a list of the origins that <see cref="IsOriginAllowed"/> accepts, such as "http://10.0.0.7:47011, http://cell:47011".</summary>
    public string AllowedOrigins(HttpContext context) => string.Join(
        ", ", OwnHosts.Of(context.Connection.LocalIpAddress, options.HostNames).Select(host => $"{Scheme}://{host}:{context.Connection.LocalPort}"));

    /// <summary>Gets the role of a request; null if its token is missing or unknown.</summary>
    /// <remarks>
    /// Checks a token even if the gateway requires none: an adapter that the gateway has started may not connect over loopback, and receives the
    /// role of a source by its token.
    /// </remarks>
    public Role? RoleOf(HttpContext context)
    {
        var known = TokenHashOf(context) is { } hash ? options.RoleOf(hash) : null;
        if (known != null || options.AsksForTokens)
            return known;
        return IsFromHere(context) ? Role.Source : Role.Observer;
    }

    /// <summary>Whether the request may control the recorder and pair headsets.</summary>
    public bool IsOperator(HttpContext context) => options.AsksForTokens ? RoleOf(context) == Role.Operator : IsFromHere(context);

    /// <summary>
    /// Gets the hash of the token in the request's header, or of the token with which its browser logged in; null if there is none. The token
    /// may be unknown.
    /// </summary>
    public byte[] TokenHashOf(HttpContext context)
    {
        var values = context.Request.Headers[HeaderNames.Authorization];
        if (values.Count == 0)
            return SessionOf(context) is { } id ? sessions.TokenHashOf(id) : null;
        var value = values.Count == 1 ? values[0] : "";
        return value.StartsWith(TokenScheme, StringComparison.OrdinalIgnoreCase) ? TokenList.HashOf(value[TokenScheme.Length..].Trim()) : null;
    }

    /// <summary>Whether the request has an Authorization header.</summary>
    public static bool HasBearer(HttpContext context) => context.Request.Headers[HeaderNames.Authorization].Count > 0;

    /// <summary>Gets a function that checks whether the login of a request is still valid; null for a request without a login.</summary>
    public Func<bool> LoginOf(HttpContext context) =>
        options.AsksForTokens && context.Request.Headers[HeaderNames.Authorization].Count == 0 && SessionOf(context) is { } id
            ? () => sessions.IsOpen(id) : null;

    /// <summary>Whether the requested host is one of the gateway's own, and not another name that resolves to its address (DNS rebinding).</summary>
    public bool IsOwnHost(HttpContext context) =>
        Uri.TryCreate($"{Scheme}://{context.Request.Host.Value}", UriKind.Absolute, out var uri)
        && OwnHosts.Contain(uri, context.Connection.LocalIpAddress, options.HostNames);

    static string SessionOf(HttpContext context) => context.Request.Cookies[BrowserSessions.CookieOf(context)];

    string Scheme => options.Certificate == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps;

    /// <summary>Whether a request comes from this machine, over a loopback address.</summary>
    public static bool IsFromHere(HttpContext context) =>
        context.Connection.RemoteIpAddress is { } remote && IPAddress.IsLoopback(remote);
}
