using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>A method that predicts the position of a joint.</summary>
/// <param name="Name">Name in tables and as a parameter of BenchmarkDotNet; one word.</param>
/// <param name="Create">Creates a predictor for one joint.</param>
public sealed record ComparedPredictor(string Name, Func<JointPredictor> Create);
