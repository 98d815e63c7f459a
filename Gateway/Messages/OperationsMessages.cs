namespace Nowpose.Gateway.Messages;

/// <summary>Responses of the operations page, and log lines about it.</summary>
static class OperationsMessages
{
    public const string PageMissing =
        "the page is missing because this gateway was built without Node.js; install Node.js 20 or newer with npm and build again";

    public static string NoPage(string page) => $"{page}: {PageMissing}";

    public const string NoTokenNeeded = "this gateway requires no token";
    public const string UnknownTokenLog = "operations: refused an unknown token";
    public const string UnknownToken = "not a token of this gateway; enter another one";
    public const string TooManyWrong = "too many wrong tokens; wait a minute";

    public const string LoggedIn = "operations: a browser logged in";

    public const string ThisMachineOnly =
        "without tokens, the operations page is available only at the gateway's address, at its machine's name and at localhost; use one of them";

    public const string UseOwnAddress = "use the gateway's address, its name or localhost";
    public const string Format = "format: must be json or csv";
}
