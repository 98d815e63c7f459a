using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Vision;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Codes as found in a picture, computed from the lit cell of each pair.</summary>
static class CodeLevels
{
    public const double Light = 0.4;

    /// <param name="signOf">For each pair: 1 if the left cell is lit, −1 if the right one is, in between if both share the exposure.</param>
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

    /// <summary>The code of LEDs that are exposed from <paramref name="start"/> for <paramref name="length"/>, both in ms.</summary>
    public static FoundCode Run(double start, double length) => Of(CodeKind.Control, pair => CodeWords.MeanSign(pair, start, length));
}
