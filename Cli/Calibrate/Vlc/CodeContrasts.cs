using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Contrast of each pair: 1 if its left cell was lit for the whole exposure, −1 for its right cell, 0 for both equally.</summary>
/// <remarks>The ring shows how bright a lit cell is. The two cells of a pair together have that brightness for every code.</remarks>
sealed class CodeContrasts
{
    /// <summary>Maximum deviation of a pair's mean, relative to the light. A darker pair is covered, a brighter one is disturbed by other light.</summary>
    const double MaxDeviation = 0.45;

    /// <summary>Minimum share of white cells of an overexposed code, or of one with a bright reflection.</summary>
    const double MinWhiteShare = 0.05;

    readonly double[] _contrasts = new double[TimestampCode.PairCount];

    public CodeContrasts(FoundCode code)
    {
        Light = Enumerable.Range(0, TimestampCode.CellCount).Where(cell => TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, code.Kind))
            .Average(cell => code.Levels[cell]);
        var dark = new List<int>();
        var brighter = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            double left = code.Levels[cell], right = code.Levels[cell + 1];
            _contrasts[pair] = (left - right) / Light;
            var deviation = (left + right - Light) / 2;
            if (deviation < -MaxDeviation * Light) dark.Add(pair);
            if (deviation > MaxDeviation * Light) brighter++;
        }
        if (dark.Count + brighter > 0)
            Fault = dark.Count >= brighter
                ? AreRowsFromAnEdge(dark) ? PictureFaults.PartlyDark : "partly covered"
                : code.WhiteShare >= MinWhiteShare ? PictureFaults.Overexposed
                : PictureFaults.Disturbed;
    }

    /// <summary>Brightness of a lit cell; 1 is white.</summary>
    public double Light { get; }

    /// <summary>Gets the reason why the code cannot be read: pairs too dark or too bright for one lit and one dark cell; null if there is none.</summary>
    public string Fault { get; }

    public double this[int pair] => _contrasts[pair];

    /// <summary>Whether the pairs are all those of the code's first or last rows. A display that scans lights one row after another.</summary>
    static bool AreRowsFromAnEdge(List<int> pairs) =>
        pairs.Count % TimestampCode.PairsPerRow == 0 && (pairs[^1] == pairs.Count - 1 || pairs[0] == TimestampCode.PairCount - pairs.Count);

    /// <summary>Gets the word of the brighter cells of all pairs.</summary>
    public int Word()
    {
        var word = 0;
        foreach (var contrast in _contrasts) word = word << 1 | (contrast > 0 ? 1 : 0);
        return word;
    }
}
