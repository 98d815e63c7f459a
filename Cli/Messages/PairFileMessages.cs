namespace Nowpose.Cli.Messages;

/// <summary>Error messages about a file of pairs of render time and L_visu.</summary>
static class PairFileMessages
{
    public static string FieldCount(string path, int row, int fields, int header) =>
        $"{path}:{row}: {fields} fields; the header has {header}; write one field for each column";
    public static string TooManyRows(string path, int row, int max) => $"{path}:{row}: more than {max} rows; remove some of them";
    public static string NoRows(string path, int min) => $"{path}: no rows below the header; at least {min} are needed";

    public static string NoColumn(string path, string column, string render, string visu) =>
        $"{path}:1: no column {column}; the header must name {render} and {visu}";

    public static string ColumnTwice(string path, string column) => $"{path}:1: column {column} occurs twice; remove one";

    public static string TwoOrigins(string path, int row, string column, string first, string other) =>
        $"{path}:{row}: {column}: is '{other}', but '{first}' in the rows above; a profile is valid for one of them only: use a table for each";

    public static string OtherSource(string path, string option, string source) =>
        $"--source: is {option}, but the render times of {path} have the source {source}; remove the option";

    public static string OtherCondition(string path, string label, string recorded, string given) =>
        $"{path} was measured with {label} '{recorded}', but the options state '{given}'; correct the option, or repeat the measurement";

    public static string NotMilliseconds(string path, int row, string column, string text) =>
        $"{path}:{row}: {column}: '{text}' is not a number of milliseconds; use a point as the decimal separator";

    public static string NotVertices(string path, int row, string column, string text, int max) =>
        $"{path}:{row}: {column}: '{text}' is not a whole number from 0 to {max}";
}
