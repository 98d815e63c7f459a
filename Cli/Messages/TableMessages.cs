using Nowpose.Gateway.Messages;

namespace Nowpose.Cli.Messages;

/// <summary>Error messages about CSV files with named columns. The reader adds the file and the line.</summary>
static class TableMessages
{
    public static string Header(string header, string expected) => $"the header is '{header}'; it must be {expected}";
    public static string FieldCount(int fields, int header) => $"{fields} fields; the header has {header}; write one field for each column";
    public static string NoRows(string path, int min) => $"{path}: no rows below the header; add at least {min}";

    public static string NotWhole(string field, string text, string unit) =>
        $"{field}: '{text}' is not a whole number of {unit} (64 bits); correct it, or remove the row";

    public static string NotANumber(string field, string text, string unit) =>
        $"{field}: '{text}' is not a number of {unit}; {MotionFileMessages.NumberRemedy(text.Contains(','))}";
}
