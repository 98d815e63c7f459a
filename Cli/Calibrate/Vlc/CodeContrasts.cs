using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// Contrast of each pair of cells: 1 if only its left cell was lit during the exposure, −1 if only its right cell, 0 if both equally.
/// </summary>
/// <remarks>The lit cells of the ring give the reference brightness. For every code, the two cells of a pair together have that brightness.</remarks>
sealed class CodeContrasts
{
    /// <summary>
    /// Maximum deviation of a pair's mean brightness from half the reference, as a share of the reference. A darker pair is covered; a brighter
    /// pair receives other light.
    /// </summary>
    const double MaxDeviation = 0.45;

    /// <summary>
    /// Dark pairs count as covered only if the median of the other pairs' absolute deviations is at most this value. An object in front of a code
    /// does not change the other pairs; a bright scene behind the code changes most of them.
    /// </summary>
    const double MaxIntactDeviation = 0.125;

    /// <summary>Minimum share of white cells in a code that counts as overexposed or covered by a bright reflection.</summary>
    const double MinWhiteShare = 0.05;

    /// <summary>
    /// Maximum residual of the control code. Another board in front of it or behind its gaps causes a larger residual, and the code can then
    /// show a time that no board shows. A hologram has no limit, because the scene behind it always causes a residual.
    /// </summary>
    const double MaxResidual = 0.16;

    /// <summary>
    /// Maximum median of the absolute contrasts of a control code. If bright light surrounds the LEDs, the ring is hardly brighter than its
    /// surroundings and seems to be darker than the pairs, whose contrasts are then 1.9 or more.
    /// </summary>
    const double MaxMedianContrast = 1.5;

    readonly double[] _contrasts = new double[TimestampCode.PairCount];

    public CodeContrasts(FoundCode code)
    {
        Light = Enumerable.Range(0, TimestampCode.CellCount).Where(cell => TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, code.Kind))
            .Average(cell => code.Levels[cell]);
        var dark = new List<int>();
        var others = new List<double>();
        var brighter = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            double left = code.Levels[cell], right = code.Levels[cell + 1];
            _contrasts[pair] = (left - right) / Light;
            var deviation = (left + right - Light) / 2;
            if (deviation < -MaxDeviation * Light) dark.Add(pair);
            else others.Add(Math.Abs(deviation));
            if (deviation > MaxDeviation * Light) brighter++;
        }
        Fault = FaultOf(code, dark, others, brighter);
    }

    /// <summary>Brightness of a lit cell; 1 is white.</summary>
    public double Light { get; }

    /// <summary>
    /// Gets the reason why the code cannot be read: some pairs are too dark or too bright, or a control code has no dark margin or a residual that is
    /// too large. Null if the code is readable.
    /// </summary>
    public string Fault { get; }

    public double this[int pair] => _contrasts[pair];

    string FaultOf(FoundCode code, List<int> dark, List<double> others, int brighter)
    {
        var isControl = code.Kind == CodeKind.Control;
        if (isControl && Quantile.Of(_contrasts.Select(Math.Abs), 0.5) > MaxMedianContrast) return PictureFaults.NoMargin;
        if (dark.Count + brighter == 0) return isControl && !code.IsWeak && code.Residual > MaxResidual ? PictureFaults.Disturbed : null;
        if (dark.Count < brighter) return code.WhiteShare >= MinWhiteShare ? PictureFaults.Overexposed : PictureFaults.Disturbed;
        if (AreRowsAtEdge(dark)) return PictureFaults.PartlyDark;
        return Quantile.Of(others, 0.5) <= MaxIntactDeviation * Light ? PictureFaults.PartlyCovered : PictureFaults.Disturbed;
    }

    /// <summary>Gets whether the pairs fill the first or the last rows of the code. A display that is lit row by row causes this.</summary>
    static bool AreRowsAtEdge(List<int> pairs) =>
        pairs.Count % TimestampCode.PairsPerRow == 0 && (pairs[^1] == pairs.Count - 1 || pairs[0] == TimestampCode.PairCount - pairs.Count);

    /// <summary>Gets the code word: each bit states which cell of a pair is brighter.</summary>
    public int Word()
    {
        var word = 0;
        foreach (var contrast in _contrasts) word = word << 1 | (contrast > 0 ? 1 : 0);
        return word;
    }
}
