namespace Nowpose.Messages
{
    /// <summary>Messages about a gateway's response to a pairing code, with remedies.</summary>
    static class PairingAnswerMessages
    {
        public static string Unencrypted(string host) => $"pairing: the code's token would be sent unencrypted to {host}; use a cell code with a pin";

        public const string NotAccepted = "the gateway does not accept this code, because it was used or is too old; look at the current code";
        public const string Cancelled = "pairing was cancelled; show the code again";
        public static string Failed(string host, string reason) => $"pairing with {host}: {reason}";
        public const string NotStarted = "the gateway does not pair headsets; start it with --pairing";
        public const string TooManyWrong = "the gateway has received too many wrong codes; try again in a minute";
        public const string NotSaved = "the gateway cannot save this headset's token; see its log";

        public static string Status(string status) => $"the gateway responded to the code with status {status}; see its log";
        public static string TooLong(int max) =>
            $"the response to the code has an unknown length or is longer than {max} bytes; check that the address in the code is that of a gateway";

        public const string NoToken = "the response to the code contains no valid token; check that the address in the code is that of a gateway";
    }
}
