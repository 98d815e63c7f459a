namespace Nowpose.Cli.Figures.Model;

/// <summary>A moment that is named in a plot.</summary>
readonly record struct PlotMark(string Label, double X);
