namespace Nowpose.Cli.Figures.Model;

/// <summary>One of several drawings in a row, for example the arm at one instant.</summary>
/// <param name="Description">Text alternative of the drawing.</param>
/// <param name="Svg">An svg element. It uses the page's colours, for example <c>var(--hold)</c>.</param>
sealed record FigureDrawing(string Title, string Description, string Svg);
