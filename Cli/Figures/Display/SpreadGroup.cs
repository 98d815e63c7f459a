namespace Nowpose.Cli.Figures.Display;

/// <summary>Pictures beyond the range that are judged on their own.</summary>
/// <param name="Name">Name of the group, for example "1.4 million".</param>
/// <param name="VisuMs">L_visu of the pictures, ms.</param>
sealed record SpreadGroup(string Name, IEnumerable<double> VisuMs);
