using Nowpose.Cli;

namespace Nowpose.Benchmarks.Load;

/// <summary>Compares the P99 of the forwarding latency of two builds of the gateway in alternating runs under the same load.</summary>
/// <remarks>The two runs of a round follow each other, so that other load on the machine affects both. Their order changes in each round.</remarks>
/// <param name="rounds">Results of this build and of the other build in each round.</param>
sealed class LoadComparison(IReadOnlyList<(LoadResult Own, LoadResult Other)> rounds)
{
    /// <summary>Maximum P99 of this build relative to the P99 of the other build.</summary>
    public const double MaxRatio = 1.2;

    /// <summary>Median over all rounds of the P99 of this build divided by the P99 of the other build.</summary>
    public double Ratio => Quantile.Of(rounds.Select(RatioOf), 0.5);

    public void Write(TextWriter to)
    {
        var table = new MarkdownTable(to, "round", "P50, other build ms", "P99, other build ms", "ratio", "cores, other build", "lost, other build");
        for (var i = 0; i < rounds.Count; i++)
        {
            var (own, other) = rounds[i];
            table.Add(
                $"{i + 1} | {own.ForwardP50Ms:0.00}, {other.ForwardP50Ms:0.00} | {own.ForwardP99Ms:0.00}, {other.ForwardP99Ms:0.00}",
                $"{RatioOf(rounds[i]):0.00} | {own.GatewayCores:0.00}, {other.GatewayCores:0.00} | {own.Lost}, {other.Lost}");
        }

        to.WriteLine();
        to.WriteLine(FormattableString.Invariant($"P99 relative to the other build, median of {rounds.Count} rounds: {Ratio:0.00}; the limit is {MaxRatio:0.0}"));
    }

    static double RatioOf((LoadResult Own, LoadResult Other) round) => round.Own.ForwardP99Ms / round.Other.ForwardP99Ms;
}
