using System.Globalization;

namespace Nowpose.Cli.Figures.Sweeps;

/// <summary>RMS errors in mm by predictor over the values of a sweep.</summary>
/// <param name="values">What was swept, ms, increasing.</param>
/// <param name="rms">By predictor, one per value; <c>hold</c> among them.</param>
sealed class SweepData(IReadOnlyList<double> values, IReadOnlyDictionary<string, double[]> rms)
{
    public IReadOnlyList<double> Values => values;

    public IReadOnlyList<double> RmsMm(string predictor) => rms[predictor];

    public bool Has(string predictor) => rms.ContainsKey(predictor);

    /// <summary>RMS over that of hold, at the index of a value.</summary>
    public double Ratio(string predictor, int index) => rms[predictor][index] / rms["hold"][index];

    /// <summary>RMS at a value that was swept.</summary>
    public double RmsAt(string predictor, double value) => rms[predictor][IndexOf(value)];

    /// <summary>RMS at one value over RMS at another.</summary>
    public double Growth(string predictor, double from, double to) => RmsAt(predictor, to) / RmsAt(predictor, from);

    /// <summary>The values at which a condition on the index holds.</summary>
    public double[] Where(Func<int, bool> condition) => [.. values.Where((_, i) => condition(i))];

    /// <summary>The predictor with the least RMS at an index.</summary>
    public string Best(int index, params string[] among) => among.MinBy(name => rms[name][index]);

    /// <summary>The value from which one predictor beats another to the end, interpolated; null where it does not at the end.</summary>
    public double? Crossover(string winner, string loser)
    {
        double Lead(int i) => rms[loser][i] - rms[winner][i];
        var i = values.Count - 1;
        if (!(Lead(i) > 0)) return null;
        while (i > 0 && Lead(i - 1) > 0) i--;
        return i == 0 ? values[0] : values[i - 1] + (values[i] - values[i - 1]) * -Lead(i - 1) / (Lead(i) - Lead(i - 1));
    }

    /// <summary>"10, 20 and 30 ms", or "none".</summary>
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
        throw new ArgumentException($"{value} ms was not swept", nameof(value));
    }
}
