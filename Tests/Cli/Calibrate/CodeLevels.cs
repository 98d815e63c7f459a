using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Creates codes as they are found in pictures, from the states of the pairs of cells.</summary>
static class CodeLevels
{
    public const double Light = 0.4;

    /// <param name="signOf">
    /// Returns, for each pair, 1 if the left cell is lit, −1 if the right cell is lit, or a value in between if each of them is lit for a part of the
    /// exposure.
    /// </param>
    public static FoundCode Of(CodeKind kind, Func<int, double> signOf, double top = 300)
    {
        var lit = new double[TimestampCode.CellCount];
        for (var cell = 0; cell < lit.Length; cell++) lit[cell] = TimestampCode.IsRing(cell) && TimestampCode.IsLitRing(cell, kind) ? 1 : 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            (lit[cell], lit[cell + 1]) = ((1 + signOf(pair)) / 2, (1 - signOf(pair)) / 2);
        }
        return new FoundCode(
            kind, [.. lit.Select(share => Light * share)],
            [(100, top), (180, top), (180, top + 80), (100, top + 80)]);
    }

    public static FoundCode Of(CodeKind kind, int value) => Of(kind, pair => CodeWords.SignOf(value, pair));

    /// <summary>Creates the code of LEDs whose exposure starts at <paramref name="start"/> and takes <paramref name="length"/>, in ms.</summary>
    public static FoundCode Run(double start, double length) => Of(CodeKind.Control, pair => CodeWords.MeanSign(pair, start, length));
}
