using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>What the pairs of a code say: 1 for the left cell lit all the exposure long, −1 for the right one, 0 for both alike.</summary>
/// <remarks>The ring tells how bright a lit cell is; of a pair both cells together have as much, whatever the code.</remarks>
sealed class CodeContrasts
{
    /// <summary>Of the light: a pair whose mean is off by more is covered, or dazzled.</summary>
    const double GreatestRest = 0.45;

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
            if (Math.Abs((left + right - Light) / 2) > GreatestRest * Light) Covered++;
        }
    }

    /// <summary>Of a lit cell: 1 is white.</summary>
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
}
