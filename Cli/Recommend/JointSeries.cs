namespace Nowpose.Cli.Recommend;

/// <summary>One joint as it was recorded.</summary>
/// <param name="Times">s, increasing.</param>
/// <param name="Positions">rad or m, one per time.</param>
readonly record struct JointSeries(string Name, IReadOnlyList<double> Times, IReadOnlyList<double> Positions);
