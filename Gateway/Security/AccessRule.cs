using System.Net;
using Microsoft.Net.Http.Headers;
using Nowpose.Gateway.Operations;

namespace Nowpose.Gateway.Security;

/// <summary>Decides who may open a WebSocket or request a page, and with which role.</summary>
/// <param name="sessions">Sessions of browsers, which open pages and WebSockets without an Authorization header.</param>
sealed class AccessRule(GatewayOptions options, BrowserSessions sessions)
{
    const string TokenScheme = "Bearer ";

    /// <summary>Whether the request comes from one of the gateway's own pages, or not from a browser page.</summary>
    /// <remarks>
    /// The Host header is not used: a page whose name was made to resolve to this address (DNS rebinding) sends its own host there. A page
    /// of the gateway was loaded from the address of this connection.
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

    /// <summary>Gets the origins that <see cref="IsOriginAllowed"/> accepts as text: "http://10.0.0.7:47011, http://cell:47011".</summary>
    public string AllowedOrigins(HttpContext context) => string.Join(
        ", ", OwnHosts.Of(context.Connection.LocalIpAddress).Select(host => $"{Scheme}://{host}:{context.Connection.LocalPort}"));

    /// <summary>Gets the role of a request, or null if its token is missing or unknown.</summary>
    /// <remarks>
    /// The gateway's own adapter sends its token even if no tokens are required, because it may connect from the address that the gateway
    /// is bound to.
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

    /// <summary>Gets the hash of the token in the request's header or of its browser's login, known or not; null if there is none.</summary>
    public byte[] TokenHashOf(HttpContext context)
    {
        var values = context.Request.Headers[HeaderNames.Authorization];
        if (values.Count == 0)
            return SessionOf(context) is { } id ? sessions.TokenHashOf(id) : null;
        var value = values.Count == 1 ? values[0] : "";
        return value.StartsWith(TokenScheme, StringComparison.OrdinalIgnoreCase) ? TokenList.HashOf(value[TokenScheme.Length..].Trim()) : null;
    }

    /// <summary>Whether the request has a token in its header.</summary>
    public static bool HasBearer(HttpContext context) => context.Request.Headers[HeaderNames.Authorization].Count > 0;

    /// <summary>Gets a check whether the login of a request is still valid; null for a request without one.</summary>
    public Func<bool> LoginOf(HttpContext context) =>
        options.AsksForTokens && context.Request.Headers[HeaderNames.Authorization].Count == 0 && SessionOf(context) is { } id
            ? () => sessions.IsOpen(id) : null;

    /// <summary>Whether the requested host is one of the gateway's own, not a name made to resolve to this address (DNS rebinding).</summary>
    public bool IsOwnHost(HttpContext context) =>
        Uri.TryCreate($"{Scheme}://{context.Request.Host.Value}", UriKind.Absolute, out var uri)
        && OwnHosts.Contain(uri, context.Connection.LocalIpAddress);

    static string SessionOf(HttpContext context) => context.Request.Cookies[BrowserSessions.CookieOf(context)];

    string Scheme => options.Certificate == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps;

    static bool IsFromHere(HttpContext context) =>
        context.Connection.RemoteIpAddress is { } remote && IPAddress.IsLoopback(remote);
}
