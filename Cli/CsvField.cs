namespace Nowpose.Cli;

/// <summary>Writes the fields of CSV text (RFC 4180).</summary>
static class CsvField
{
    /// <summary>Returns a field as it is, or in quotation marks if it contains a comma, a quotation mark or a line break.</summary>
    public static string Quoted(string field) => field?.IndexOfAny([',', '"', '\n', '\r']) >= 0
        ? '"' + field.Replace("\"", "\"\"", StringComparison.Ordinal) + '"' : field;
}
