namespace Nowpose.Gateway.Messages;

/// <summary>Responses to clients without access, and log lines about them.</summary>
static class AccessMessages
{
    public static string OtherOrigin(string allowed) => $"the Origin header does not name a page of the gateway; allowed: {allowed}";

    public const string OperatorOnly =
        "this needs the role operator; log in with an operator's token (\"operator TOKEN\" in the token file). If the gateway has no tokens, "
        + "use a browser on the gateway's machine";

    public static string Method(PathString path, string allowed) => $"{path}: the method must be {allowed}";

    public const string Token = "the bearer token is missing or unknown; send a token of the gateway's token file, or pair again";
    public const string TooManyWrongLog = "websocket: refused a connection, too many wrong tokens from its address";

    public static string TooManyWrong(string answer) => $"{answer}; too many wrong tokens from this address; wait a minute";
    public static string Refused(Closure why) => $"websocket: refused a connection (reason: {why})";
    public static string NotChecked(string kind, string reason) =>
        $"security: tokens and certificate could not be checked ({kind}: {reason}); check the permissions of their files";

    public const string OtherLinesUsed = "; its other lines are used";
    public const string FormerContentUsed = "; its previous content stays in use, including removed lines";
    public const string ClosedForNewer = "websocket: closed a connection without authentication in favour of a newer one";
}
