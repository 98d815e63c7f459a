using System.Text.Json;
using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>The layout of a code for the worker, so that <see cref="TimestampCode"/> is the only specification.</summary>
static class CodePattern
{
    public static string Json()
    {
        int[] ring = [.. Enumerable.Range(0, TimestampCode.CellCount).Where(TimestampCode.IsRing)];
        var pattern = new
        {
            side = TimestampCode.Side,
            pairs = Enumerable.Range(0, TimestampCode.PairCount).Select(TimestampCode.CellOf),
            ring,
            kinds = Enum.GetValues<CodeKind>().ToDictionary(kind => kind.ToString(), kind => new
            {
                lit = ring.Select(cell => TimestampCode.IsLitRing(cell, kind)),
                // The headset draws squares; the control system may use LEDs.
                isFilled = kind == CodeKind.Headset,
            }),
        };
        return JsonSerializer.Serialize(new { pattern });
    }
}
