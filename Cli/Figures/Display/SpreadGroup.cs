namespace Nowpose.Cli.Figures.Display;

/// <summary>A group of pictures beyond the range with its own mean, for example the pictures at one load.</summary>
/// <param name="Name">Name of the group, for example "1.4 million".</param>
/// <param name="VisuMs">L_visu of the pictures, ms.</param>
sealed record SpreadGroup(string Name, IEnumerable<double> VisuMs);
