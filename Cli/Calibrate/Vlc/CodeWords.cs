using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Converts between the values and the words of all valid codes.</summary>
static class CodeWords
{
    static readonly int[] Words = [.. Enumerable.Range(0, TimestampCode.PeriodMs).Select(TimestampCode.WordOf)];

    // For each pair, the time with bit 1 minus the time with bit 0, from value 0 up to each value, ms.
    static readonly int[][] Sums = [.. Enumerable.Range(0, TimestampCode.PairCount).Select(SumsOf)];

    /// <summary>Gets 1 if the pair's left cell is lit, or −1 if its right cell is lit.</summary>
    /// <param name="value">Any integer; codes repeat.</param>
    public static int SignOf(int value, int pair) => (Words[Wrap(value)] >> (TimestampCode.PairCount - 1 - pair) & 1) * 2 - 1;

    /// <summary>Gets the values whose words equal the given word in the bits of a mask.</summary>
    public static IEnumerable<int> Matching(int word, int mask)
    {
        for (var value = 0; value < Words.Length; value++)
            if (((Words[value] ^ word) & mask) == 0) yield return value;
    }

    /// <summary>Gets the value of a word, or −1 if its parity is wrong.</summary>
    public static int ValueOf(int word)
    {
        var value = word >> 2;
        for (var shift = 1; shift < TimestampCode.ValueBits; shift <<= 1) value ^= value >> shift;
        return Words[value] == word ? value : -1;
    }

    /// <summary>Gets the mean sign of a pair, −1 to 1, over an interval in which consecutive codes are shown.</summary>
    /// <param name="start">Start of the interval, ms, at most one period from 0. Value v is shown from v to v + 1.</param>
    /// <param name="length">Length of the interval, greater than 0, ms.</param>
    public static double MeanSign(int pair, double start, double length) => (SumTo(pair, start + length) - SumTo(pair, start)) / length;

    static double SumTo(int pair, double time)
    {
        var whole = Math.Floor(time);
        var value = (int)whole;
        var periods = Math.DivRem(value - Wrap(value), TimestampCode.PeriodMs).Quotient;
        return periods * Sums[pair][TimestampCode.PeriodMs] + Sums[pair][Wrap(value)] + (time - whole) * SignOf(value, pair);
    }

    static int[] SumsOf(int pair)
    {
        var sums = new int[TimestampCode.PeriodMs + 1];
        for (var value = 0; value < TimestampCode.PeriodMs; value++) sums[value + 1] = sums[value] + SignOf(value, pair);
        return sums;
    }

    static int Wrap(int value) => value & (TimestampCode.PeriodMs - 1);
}
