namespace Nowpose.Messages
{
    /// <summary>Error messages about markers and a base's set of markers.</summary>
    static class MarkerMessages
    {
        public const string PayloadEmpty = "marker: its payload is empty; enter the text of its code";

        public static string PayloadTooLong(int length, int max) =>
            $"marker: its payload has {length} characters; the maximum is {max}; use a shorter text for its code";

        public static string RotationInvalid(string marker) => $"{marker}: its rotation is invalid; enter three finite angles";
        public static string PayloadTwice(string marker) => $"{marker} is listed twice; each marker of a base needs its own payload";
    }
}
