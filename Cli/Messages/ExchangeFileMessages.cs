namespace Nowpose.Cli.Messages;

/// <summary>Error messages about logs of sync exchanges.</summary>
static class ExchangeFileMessages
{
    public static string NoRows(string path) => $"{path}: no rows below the header; at least one is needed";
    public static string FieldCount(string path, int row, int fields, int expected) =>
        $"{path}:{row}: the row has {fields} fields; it must have {expected}";

    public static string NotNanoseconds(string path, int row, string field, string text) =>
        $"{path}:{row}: {field}: '{text}' is not a whole number of nanoseconds (64 bits); correct it, or remove the row";

    public static string NoExchange(string path) => $"{path}: contains no sync exchange; at least one is needed";

    public static string TimeOrder(string path, int row, long ns, long previousNs) =>
        $"{path}:{row}: t_ns: {ns} ns is not after {previousNs} ns; times must increase";

    public static string Header(string path, int row, string header, string expected) =>
        $"{path}:{row}: the header is '{header}'; it must be {expected}";
}
