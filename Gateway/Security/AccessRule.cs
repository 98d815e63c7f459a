using System.Net;
using Microsoft.Net.Http.Headers;

namespace Nowpose.Gateway.Security;

/// <summary>Who may open a WebSocket, and as what.</summary>
sealed class AccessRule(GatewayOptions options)
{
    const string Scheme = "Bearer ";

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
            && origin.Scheme == (options.Certificate == null ? Uri.UriSchemeHttp : Uri.UriSchemeHttps)
            && origin.Port == context.Connection.LocalPort
            && IsOwnHost(origin, context.Connection.LocalIpAddress);
    }

    /// <summary>The role of whoever asks, or null when it has none of the tokens asked for.</summary>
    public Role? RoleOf(HttpContext context)
    {
        if (options.Tokens.IsEmpty)
            return IsFromHere(context) ? Role.Source : Role.Observer;
        var values = context.Request.Headers[HeaderNames.Authorization];
        var value = values.Count == 1 ? values[0] : "";
        return value.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase) ? options.Tokens.RoleOf(value[Scheme.Length..].Trim()) : null;
    }

    static bool IsFromHere(HttpContext context) =>
        context.Connection.RemoteIpAddress is { } remote && IPAddress.IsLoopback(remote);

    static bool IsOwnHost(Uri origin, IPAddress local)
    {
        if (IPAddress.TryParse(origin.IdnHost, out var address))
            return address.MapToIPv6().Equals(local.MapToIPv6());
        return IPAddress.IsLoopback(local) && origin.Host == "localhost"
            || origin.Host.Equals(Environment.MachineName, StringComparison.OrdinalIgnoreCase);
    }
}
