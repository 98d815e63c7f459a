using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about the codes of cells and gateways.</summary>
    static class PairingCodeMessages
    {
        public const string PinMissing =
            "cell code: the certificate pin is missing; only a gateway on the headset's own machine can be used without it; print the code again";

        public const string PinInvalid = "certificate pin is not the base64url encoding of 32 bytes; print the code again";

        public static string MarkerSize(string min, string max) => $"marker size is not a number; allowed: {min} to {max} m";

        public static string CellCodeTooLong(int length, int max) =>
            $"cell code: {length} characters; allowed: up to {max}; shorten the names of cell and host";

        public static string NameLength(string what, int length, int max) => $"{what}: is {length} characters long; allowed: 1 to {max}";

        public static string NameCharacter(string what, int position, int character) =>
            FormattableString.Invariant($"{what}: character {position} is U+{character:X4}; allowed: letters, digits, spaces, hyphens, ")
            + "underscores and full stops";

        public static string NameSpace(string what) => $"{what}: begins or ends with a space; remove it";
        public static string NotEncoded(string what, int position) => $"{what}: character {position} must be percent-encoded as %XX";
        public static string NotUtf8(string what) => $"{what}: its percent-encoded bytes are not UTF-8; print the code again";
        public static string TooLong(int length, int max) => $"{length} characters; allowed: up to {max}";
        public static string OtherBegin(string begin) => $"does not begin with {begin}";
        public static string NoFields(string allowed) => $"has no fields; allowed: {allowed}";

        public static string Character(int position, int character) =>
            FormattableString.Invariant($"character {position} is U+{character:X4}; allowed: ASCII without spaces and control characters");

        public static string NoVersion(int version) => $"has no valid version number; allowed: {version}; show the code again";

        public static string OtherVersion(int version, int supported) =>
            $"has version {version}; this release of Nowpose reads version {supported}; update Nowpose";

        public static string FieldMissing(char key) => $"{key} is missing; show the code again";
        public static string FieldEmpty(char key) => $"{key} is empty; show the code again";
        public static string FieldTwice(char key) => $"{key} occurs twice; show the code again";
        public static string NotAField(string allowed) => $"a field is not KEY=VALUE; allowed: {allowed}";
        public static string UnknownField(char key, string allowed) => $"field {key} is not known; allowed: {allowed}";

        public static string NotAHost(string what, string host) =>
            $"{what}: '{host}' is not a host; allowed: a name of ASCII letters, digits, hyphens and dots, or an IPv4 or IPv6 address";

        public static string OffsetCount(string what, int count) =>
            $"{what}: {count} numbers; allowed: x,y,z or x,y,z,roll,pitch,yaw in metres and degrees";

        public static string OffsetNumber(string what, int position) =>
            $"{what}: value {position} is not valid; allowed: a number with up to three digits before the decimal point and up to six after it";

        public const string NotACode = "pairing code: the text is not a code of Nowpose; read the code on the marker or on the gateway's page";

        public const string UnknownKind = "pairing code: it is neither a cell code nor a token code; update Nowpose if it is older than the gateway";

        public static string CodeTooLong(int length, int max) => $"pairing code: {length} characters; allowed: up to {max}";

        public static string TooManyInView(int max, int minutes) =>
            $"pairing codes: {max} different codes were in view, which is the maximum; new codes are ignored until some of them have been out "
            + $"of view for {minutes} minutes, or until a restart";

        public static string TokenInvalid(int bytes) => $"token code: the token is not the base64url encoding of {bytes} bytes; show the code again";

        public static string OutOfRange(char key, long value, long min, long max) => $"{key}={value}; allowed: {min} to {max}";
        public static string NotWhole(char key, long min, long max) => $"{key} is not a whole number; allowed: {min} to {max}";
    }
}
