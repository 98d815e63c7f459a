using System.Globalization;
using Nowpose.Benchmarks.Comparison;

namespace Nowpose.Benchmarks;

/// <summary>Writes the errors and costs of all candidates as one Markdown table.</summary>
static class ComparisonTable
{
    public static void Write(CostTable costs, TextWriter to)
    {
        if (costs.IsEmpty) return;
        var errors = new ErrorStudy(ComparedMotions.CheckingSeeds);
        var baseline = ComparedPredictors.Named(ComparedPredictors.Baseline);

        to.WriteLine();
        var table = new MarkdownTable(to, ["RMS error ÷ hold's", .. ComparedPredictors.All.Select(candidate => candidate.Name)]);
        foreach (var condition in ComparedMotions.All) Row(table, condition.Name, candidate => Share(errors[candidate, condition]));
        Row(table, "geometric mean", candidate => Share(errors.Mean(candidate)));
        Row(table, "– ÷ quadratic's", candidate => Ratio(errors.Mean(candidate) / errors.Mean(baseline)));
        Row(table, "time per joint and sample, ns", candidate => Number(costs.Sample(candidate)?.Nanoseconds));
        Row(table, "– ÷ quadratic's", candidate => Ratio(costs.Sample(candidate)?.Nanoseconds / costs.Sample(baseline)?.Nanoseconds));
        Row(table, "time per joint and frame, ns", candidate => Number(costs.Frame(candidate)?.Nanoseconds));
        Row(table, "– ÷ quadratic's", candidate => Ratio(costs.Frame(candidate)?.Nanoseconds / costs.Frame(baseline)?.Nanoseconds));
        Row(table, "allocated per sample, B", candidate => Number(costs.Sample(candidate)?.Bytes));
        Row(table, "allocated per frame, B", candidate => Number(costs.Frame(candidate)?.Bytes));
        to.WriteLine();
        to.WriteLine($"Errors on seeds {string.Join(", ", ComparedMotions.CheckingSeeds)}; constants of the last three tuned on {string.Join(", ", ComparedMotions.TuningSeeds)}.");
    }

    static void Row(MarkdownTable table, string name, Func<ComparedPredictor, string> cell) =>
        table.AddCells([name, .. ComparedPredictors.All.Select(cell)]);

    static string Share(double value) => value.ToString("0.000", CultureInfo.InvariantCulture);

    // Uses two decimals below 1 and one below 10; empty if the value was not measured.
    static string Ratio(double? value) => Text(value, value < 1 ? "0.00" : value < 10 ? "0.0" : "0");

    static string Number(double? value) => Text(value, value is > 0 and < 10 ? "0.0" : "0");

    static string Text(double? value, string format) => value?.ToString(format, CultureInfo.InvariantCulture) ?? "";
}
