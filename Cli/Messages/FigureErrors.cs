namespace Nowpose.Cli.Messages;

/// <summary>Errors in the computation of figures that only a fault of this program can cause.</summary>
static class FigureErrors
{
    public const string NoCriterion = "a claim needs at least one criterion";

    public static string NotFinite(string column, int row, double? value) => $"column {column}, row {row}: {value} is not a finite number";
    public static string NotAValue(double ms) => $"{ms} ms is not a value of the sweep";
    public static string NoSwing(int run, string predictor) => $"run {run} of the swing with {predictor} has no whole swing";
}
