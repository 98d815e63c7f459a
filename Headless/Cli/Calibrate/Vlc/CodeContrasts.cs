using MathNet.Numerics.LinearRegression;
using Nowpose.VisibleLight;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>What the pairs of a code say: 1 for the left cell lit all the exposure long, −1 for the right one, 0 for both alike.</summary>
/// <remarks>
/// Levels are explained by a scene that changes gently across the code plus the light of lit cells. The ring tells how bright that
/// is; of a pair the mean has half of it, whatever the code.
/// </remarks>
sealed class CodeContrasts
{
    /// <summary>Of the light: a pair whose mean is off by more is covered, or dazzled.</summary>
    const double GreatestRest = 0.45;

    readonly double[] _contrasts = new double[TimestampCode.PairCount];

    public CodeContrasts(FoundCode code)
    {
        var design = new List<double[]>();
        var observed = new List<double>();
        for (var cell = 0; cell < TimestampCode.CellCount; cell++)
        {
            if (!TimestampCode.IsRing(cell)) continue;
            design.Add(Row(cell % TimestampCode.Side, cell / TimestampCode.Side, TimestampCode.IsLitRing(cell, code.Kind) ? 1 : 0));
            observed.Add(code.Levels[cell]);
        }
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            design.Add(Row(cell % TimestampCode.Side + 0.5, cell / TimestampCode.Side, 0.5));
            observed.Add((code.Levels[cell] + code.Levels[cell + 1]) / 2);
        }
        var found = MultipleRegression.QR([.. design], [.. observed], intercept: false);
        Light = found[0];
        var pairsStart = observed.Count - TimestampCode.PairCount;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            _contrasts[pair] = (code.Levels[cell] - code.Levels[cell + 1]) / Light;
            var rest = observed[pairsStart + pair] - design[pairsStart + pair].Zip(found, (a, b) => a * b).Sum();
            if (Math.Abs(rest) > GreatestRest * Light) Covered++;
        }
    }

    /// <summary>Of a lit cell, above the scene: 1 is white.</summary>
    public double Light { get; }

    /// <summary>Pairs that are too bright or too dark for one lit cell and one dark one.</summary>
    public int Covered { get; }

    public double this[int pair] => _contrasts[pair];

    /// <summary>The word that the brighter cell of each pair says.</summary>
    public int Word()
    {
        var word = 0;
        foreach (var contrast in _contrasts) word = word << 1 | (contrast > 0 ? 1 : 0);
        return word;
    }

    // The light, then the scene, which bends at most as a parabola.
    static double[] Row(double column, double row, double light)
    {
        double x = column / (TimestampCode.Side - 1) - 0.5, y = row / (TimestampCode.Side - 1) - 0.5;
        return [light, 1, x, y, x * x, x * y, y * y];
    }
}
