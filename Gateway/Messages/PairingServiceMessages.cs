namespace Nowpose.Gateway.Messages;

/// <summary>Responses of the pairing page and of the pairing service, and log lines about them.</summary>
static class PairingServiceMessages
{
    public static string MarkerSize(string text) => $"marker size: '{text}' is not a size; allowed: 10 to 999 mm";

    public const string ThisMachineOnly =
        "the pairing page is available only to operators, and on the gateway's machine at localhost; log in on the operations page with an "
        + "operator's token, or open the page on that machine at localhost";

    /// <summary>For a gateway that listens on one address other than loopback.</summary>
    public const string OperatorsOnly =
        "the pairing page is available only to operators, because the gateway does not listen at localhost; log in on the operations page with an "
        + "operator's token (--tokens FILE), or start the gateway with --bind any and open the page on that machine at localhost";

    public const string Fields = "the fields token and name are needed";

    public static string TooManyWrong(int max) => $"more than {max} wrong codes in a minute; wait a minute";

    public const string CodeRenewed = "pairing: the code was renewed";
    public const string NotStored = "the headset's token cannot be stored; see the gateway's log";

    public static string NotStoredLog(string reason) => $"pairing: {reason}";
    public const string TokenGiven = "pairing: gave a token";
    public static string To(string headset) => $" to the headset '{headset}'";

    public const string WrongCodeLog = "pairing: rejected a wrong code";
    public const string WrongCode = "this code is not valid; look at the code that the gateway shows now";
    public const string NotJson = "the body must be a JSON object whose values are strings, and the header Content-Length is needed";
}
