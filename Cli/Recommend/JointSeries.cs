namespace Nowpose.Cli.Recommend;

/// <summary>The recorded positions of one joint.</summary>
/// <param name="Times">Times in s, increasing.</param>
/// <param name="Positions">Positions in rad or m, one per time.</param>
readonly record struct JointSeries(string Name, IReadOnlyList<double> Times, IReadOnlyList<double> Positions);
