using System.Net;
using Microsoft.Net.Http.Headers;

namespace Nowpose.Gateway.Security;

/// <summary>Who may open a WebSocket, and as what.</summary>
sealed class AccessRule(GatewayOptions options)
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
    public Role? RoleOf(HttpContext context)
    {
        if (!options.AsksForTokens)
            return IsFromHere(context) ? Role.Source : Role.Observer;
        var values = context.Request.Headers[HeaderNames.Authorization];
        var value = values.Count == 1 ? values[0] : "";
        return value.StartsWith(TokenScheme, StringComparison.OrdinalIgnoreCase) ? options.RoleOf(value[TokenScheme.Length..].Trim()) : null;
    }

    string Scheme => options.Certificate == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps;

    static bool IsFromHere(HttpContext context) =>
        context.Connection.RemoteIpAddress is { } remote && IPAddress.IsLoopback(remote);
}
