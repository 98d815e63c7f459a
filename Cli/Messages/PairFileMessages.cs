namespace Nowpose.Cli.Messages;

/// <summary>Error messages about a file of pairs of render time and L_visu.</summary>
static class PairFileMessages
{
    public static string TooManyRows(int max) => $"more than {max} rows; remove some of them";
    public static string NoColumn(string column, string render, string visu) => $"no column {column}; the header must name {render} and {visu}";
    public static string ColumnTwice(string column) => $"column {column} occurs twice; remove one";

    public static string TwoOrigins(string column, string first, string other) =>
        $"{column}: is '{other}', but '{first}' in the rows above; a profile is valid for one of them only: use a table for each";

    public static string OtherSource(string path, string option, string source) =>
        $"--source: is {option}, but the render times of {path} have the source {source}; remove the option";

    public static string OtherCondition(string path, string label, string recorded, string given) =>
        $"{path} was measured with {label} '{recorded}', but the options state '{given}'; correct the option, or repeat the measurement";

    public static string NotVertices(string column, string text, int max) => $"{column}: '{text}' is not a whole number from 0 to {max}";
}
