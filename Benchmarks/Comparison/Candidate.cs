using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>A method for the prediction of a joint.</summary>
/// <param name="Name">A word for tables and for BenchmarkDotNet's parameter.</param>
/// <param name="Create">Creates a new instance for a joint.</param>
public sealed record Candidate(string Name, Func<JointPredictor> Create);
