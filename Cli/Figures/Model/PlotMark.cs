namespace Nowpose.Cli.Figures.Model;

/// <summary>A labelled position on the horizontal axis of a plot.</summary>
readonly record struct PlotMark(string Label, double X);
