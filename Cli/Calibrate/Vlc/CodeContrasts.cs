using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Contrast of each pair: 1 if its left cell was lit for the whole exposure, −1 for its right cell, 0 for both equally.</summary>
/// <remarks>The ring shows how bright a lit cell is. The two cells of a pair together have that brightness for every code.</remarks>
sealed class CodeContrasts
{
    /// <summary>Maximum deviation of a pair's mean, relative to the light. A pair beyond it is covered or overexposed.</summary>
    const double MaxDeviation = 0.45;

    readonly double[] _contrasts = new double[TimestampCode.PairCount];

    public CodeContrasts(FoundCode code)
    {
        Light = Enumerable.Range(0, TimestampCode.CellCount).Where(cell => TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, code.Kind))
            .Average(cell => code.Levels[cell]);
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            double left = code.Levels[cell], right = code.Levels[cell + 1];
            _contrasts[pair] = (left - right) / Light;
            if (Math.Abs((left + right - Light) / 2) > MaxDeviation * Light) Covered++;
        }
    }

    /// <summary>Brightness of a lit cell; 1 is white.</summary>
    public double Light { get; }

    /// <summary>Number of pairs that are too bright or too dark for one lit and one dark cell.</summary>
    public int Covered { get; }

    public double this[int pair] => _contrasts[pair];

    /// <summary>Gets the word of the brighter cells of all pairs.</summary>
    public int Word()
    {
        var word = 0;
        foreach (var contrast in _contrasts) word = word << 1 | (contrast > 0 ? 1 : 0);
        return word;
    }
}
