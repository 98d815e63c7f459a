namespace Nowpose.Cli.Figures.Model;

/// <summary>An instant with a label in a plot.</summary>
readonly record struct PlotMark(string Label, double X);
