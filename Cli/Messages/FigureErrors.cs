namespace Nowpose.Cli.Messages;

/// <summary>Messages about errors in the computation of figures. Only a fault in this program can cause these errors.</summary>
static class FigureErrors
{
    public const string NoCriterion = "a claim needs at least one criterion";

    public static string ValueCount(int values, int columns) => $"{values} values were passed for {columns} columns; pass one value for each column";
    public static string NotFinite(string column, int row, double? value) => $"column {column}, row {row}: {value} is not a finite number";
    public static string NotAValue(double ms) => $"{ms} ms is not a value of the sweep";
    public static string NoSwing(int run, string predictor) => $"run {run} of the swing with {predictor} has no whole swing";
}
