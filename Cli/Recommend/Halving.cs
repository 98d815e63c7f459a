namespace Nowpose.Cli.Recommend;

/// <summary>Finds where a recording has half of its motion behind it.</summary>
/// <remarks>
/// Half of the time would do where a robot moves all the while. Many recordings end, or begin, with a rest: whatever is tried on
/// that would be judged by its noise.
/// </remarks>
static class Halving
{
    /// <summary>Of the whole, on either side: a part that is too short says nothing either.</summary>
    const double LeastShare = 0.2;

    /// <param name="ways">How far the joints moved in each step, all joints together.</param>
    /// <returns>How many of the steps belong to the first half.</returns>
    public static int MiddleOf(IReadOnlyList<double> ways)
    {
        var least = (int)(LeastShare * ways.Count);
        var half = ways.Sum() / 2;
        var (middle, way) = (0, 0.0);
        while (middle < ways.Count && way < half) way += ways[middle++];
        return half > 0 ? Math.Clamp(middle, least, ways.Count - least) : ways.Count / 2;
    }
}
