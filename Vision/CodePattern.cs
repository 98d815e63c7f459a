using System.Text.Json;
using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>Describes the layout of a code for the worker process, so that only <see cref="TimestampCode"/> specifies it.</summary>
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
                // The headset draws complete squares. The control system can use LEDs, which leave gaps.
                isFilled = kind == CodeKind.Headset,
            }),
        };
        return JsonSerializer.Serialize(new { pattern });
    }
}
