using System.Net;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Messages;

/// <summary>Responses to clients without access, and log lines about them.</summary>
static class AccessMessages
{
    public static string OtherOrigin(string allowed) => $"the Origin header does not name a page of the gateway; allowed: {allowed}";

    public const string OperatorOnly =
        "this needs the role operator; log in with an operator's token (\"operator TOKEN\" in the token file). If the gateway has no tokens, "
        + "use a browser on the gateway's machine";

    public const string OperatorOnlyLog = "access: refused a request that needs the role operator";

    public static string Method(PathString path, string allowed) => $"{path}: the method must be {allowed}";

    public const string Token = "the bearer token is missing or unknown; send a token of the gateway's token file, or pair again";
    public const string TooManyWrongLog = "websocket: refused a connection, too many wrong tokens from its address";

    public static string TooManyWrong(string answer) => $"{answer}; too many wrong tokens from this address; wait a minute";
    public const string BlockedLog = "access: refused a log-in or a pairing, too many wrong tokens or codes";

    public static string Refused(Closure why) => $"websocket: refused a connection (reason: {why})";

    /// <summary>Adds the client to a line: its address, role, and the beginning of its token's hash.</summary>
    /// <param name="role">
    /// Role of the client; null if it is unknown. An unknown token has no hash in the line, because it may be a password that was entered by mistake.
    /// </param>
    /// <param name="hash">Hash of the client's token; null if it has none, and for a weak token.</param>
    public static string By(string line, IPAddress address, Role? role, byte[] hash)
    {
        var plain = address is { IsIPv4MappedToIPv6: true } ? address.MapToIPv4() : address;
        var token = hash == null ? null : $", token {Convert.ToHexStringLower(hash)[..8]}";
        return $"{line} from {plain}{(role == null ? null : $" ({role.ToString().ToLowerInvariant()}{token})")}";
    }

    public static string NotChecked(string reason) =>
        $"security: tokens and certificate could not be checked ({reason}); check the permissions of their files";

    public const string OtherLinesUsed = "; its other lines are used";
    public const string FormerContentUsed = "; its previous content stays in use, including removed lines";
    public const string ClosedForNewer = "websocket: closed a connection without authentication in favour of a newer one";
}
