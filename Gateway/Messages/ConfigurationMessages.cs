namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about a configuration file. The reader adds the file and the line.</summary>
static class ConfigurationMessages
{
    public static string SecondDocument(string place) => $"{place}: a second YAML document starts here; keep only one in the file";
    public static string NotYaml(string place) => $"{place}: not valid YAML, on this line or a later one; correct it";
    public static string TooLong(string path, long bytes, int max) => $"--config {path}: {bytes} bytes; the maximum is {max}";
    public static string NoEntry(string place) => $"{place}: a line \"key: value\" is needed";
    public static string KeyNotAWord(string place) => $"{place}: a key must be a scalar without a tag or an anchor";
    public static string KeyTwice(string place, string key, string earlier) => $"{place}: {key}: occurs twice, first at {earlier}; remove one";

    public static string ValueNotAWord(string place, string key) =>
        $"{place}: {key}: must be a scalar or a list of scalars, without tags or anchors";

    public static string UnknownEntry(string verb, string allowed) => $"'{verb}' has no such entry; {allowed}";

    public const string List = "is a list; give one value";
    public const string ControlCharacter = "contains a line end or another control character; remove it. "
        + "In double quotes, \\ begins an escape sequence: write a path of Windows without quotes";

    public static string NotASwitch(string value) => $"'{value}' is neither true nor false; use one of the two";
}
