using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>One way to predict a joint.</summary>
/// <param name="Name">A word for tables and for BenchmarkDotNet's parameter.</param>
/// <param name="Create">Makes a fresh one for a joint.</param>
public sealed record Candidate(string Name, Func<JointPredictor> Create);
