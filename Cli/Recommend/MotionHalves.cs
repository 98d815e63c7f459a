namespace Nowpose.Cli.Recommend;

/// <summary>Finds the point that divides a recording into two halves with the same amount of motion.</summary>
/// <remarks>
/// Many recordings begin or end with a rest. If they were divided by time, a half could contain only noise.
/// </remarks>
static class MotionHalves
{
    /// <summary>Minimum share of the steps in each half. A shorter half would give no meaningful result.</summary>
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
