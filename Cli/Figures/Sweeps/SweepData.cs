using System.Globalization;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>RMS errors of all predictors for the values of a sweep, mm.</summary>
/// <param name="values">Values of the changed condition, ms, increasing.</param>
/// <param name="rms">RMS errors of each predictor, including <c>hold</c>; one per value.</param>
sealed class SweepData(IReadOnlyList<double> values, IReadOnlyDictionary<string, double[]> rms)
{
    public IReadOnlyList<double> Values => values;

    public IReadOnlyList<double> RmsMm(string predictor) => rms[predictor];

    /// <summary>Gets a predictor's RMS error divided by the RMS error of hold, for the value at an index.</summary>
    public double Ratio(string predictor, int index) => rms[predictor][index] / rms["hold"][index];

    /// <summary>Gets a predictor's RMS error for a value.</summary>
    public double RmsAt(string predictor, double value) => rms[predictor][IndexOf(value)];

    /// <summary>Gets a predictor's RMS error for one value divided by its RMS error for another value.</summary>
    public double Growth(string predictor, double from, double to) => RmsAt(predictor, to) / RmsAt(predictor, from);

    /// <summary>Gets the values whose index satisfies a condition.</summary>
    public double[] Where(Func<int, bool> condition) => [.. values.Where((_, i) => condition(i))];

    /// <summary>Gets the predictor with the smallest RMS error for the value at an index.</summary>
    public string Best(int index, params string[] among) => among.MinBy(name => rms[name][index]);

    /// <summary>
    /// Gets the interpolated value above which one predictor is always better than another; null if it is not better for the
    /// last value.
    /// </summary>
    public double? Crossover(string winner, string loser)
    {
        double Lead(int i) => rms[loser][i] - rms[winner][i];
        var i = values.Count - 1;
        if (!(Lead(i) > 0)) return null;
        while (i > 0 && Lead(i - 1) > 0) i--;
        return i == 0 ? values[0] : values[i - 1] + (values[i] - values[i - 1]) * -Lead(i - 1) / (Lead(i) - Lead(i - 1));
    }

    /// <summary>Formats values as "10, 20 and 30 ms", or "none".</summary>
    public static string List(IReadOnlyList<double> ms)
    {
        var words = ms.Select(v => v.ToString("0.#", CultureInfo.InvariantCulture)).ToArray();
        return words.Length switch
        {
            0 => "none",
            1 => words[0] + " ms",
            _ => string.Join(", ", words[..^1]) + " and " + words[^1] + " ms",
        };
    }

    int IndexOf(double value)
    {
        for (var i = 0; i < values.Count; i++) if (values[i] == value) return i;
        throw new ArgumentException(FigureErrors.NotAValue(value), nameof(value));
    }
}
