namespace Nowpose.Cli.Recommend;

/// <summary>Finds the point that divides a recording into two halves with equal motion.</summary>
/// <remarks>
/// Half of the time would be sufficient if a robot moved without pause. Many recordings begin or end with a rest, on which a candidate
/// would be judged by its noise.
/// </remarks>
static class Halving
{
    /// <summary>Minimum share of the steps on either side. A shorter part is not meaningful.</summary>
    const double MinShare = 0.2;

    /// <param name="ways">Distance that all joints together moved in each step.</param>
    /// <returns>Number of steps in the first half.</returns>
    public static int MiddleOf(IReadOnlyList<double> ways)
    {
        var min = (int)(MinShare * ways.Count);
        var half = ways.Sum() / 2;
        var (middle, way) = (0, 0.0);
        while (middle < ways.Count && way < half) way += ways[middle++];
        return half > 0 ? Math.Clamp(middle, min, ways.Count - min) : ways.Count / 2;
    }
}
