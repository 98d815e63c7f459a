using System.Text.Json;

namespace Nowpose.Cli.Demo;

/// <summary>The figures of several runs that differ in their seeds.</summary>
/// <param name="Seeds">The seed of each run.</param>
/// <param name="Figures">The numbers of result.json by their path, for example <c>tool_error_mm.rms</c>.</param>
sealed record DemoRepeats(IReadOnlyList<int> Seeds, IReadOnlyDictionary<string, DemoRepeats.Figure> Figures)
{
    /// <summary>One number of all runs. Mean, minimum and maximum are those of the runs that have a value.</summary>
    /// <param name="Values">The value of each run; null for a run without a value.</param>
    public sealed record Figure(double Mean, double Min, double Max, IReadOnlyList<double?> Values);

    /// <summary>Collects the numbers of the results. A number that no run has is left out.</summary>
    /// <param name="results">One result or more.</param>
    public static DemoRepeats Of(IReadOnlyList<DemoResult> results)
    {
        List<Dictionary<string, double>> runs = [.. results.Select(result => NumbersOf(result with { Conditions = null }))];
        return new DemoRepeats(
            [.. results.Select(result => result.Conditions.Seed)],
            runs.SelectMany(run => run.Keys).Distinct().ToDictionary(name => name, name => Of(runs, name)));
    }

    static Figure Of(List<Dictionary<string, double>> runs, string name)
    {
        List<double?> values = [.. runs.Select(run => run.TryGetValue(name, out var value) ? value : (double?)null)];
        return new Figure(values.Average().Value, values.Min().Value, values.Max().Value, values);
    }

    static Dictionary<string, double> NumbersOf(DemoResult result)
    {
        using var json = JsonDocument.Parse(JsonText.Of(result));
        return NumbersIn(json.RootElement, "").ToDictionary(number => number.Name, number => number.Value);
    }

    static IEnumerable<(string Name, double Value)> NumbersIn(JsonElement element, string path) => element.ValueKind switch
    {
        JsonValueKind.Number => [(path, element.GetDouble())],
        JsonValueKind.Object => element.EnumerateObject()
            .SelectMany(property => NumbersIn(property.Value, path.Length == 0 ? property.Name : path + "." + property.Name)),
        _ => [],
    };
}
