namespace Nowpose.Cli.Figures.Model;

/// <summary>A drawing next to others, for example the arm at one instant.</summary>
/// <param name="Description">Text alternative of the drawing.</param>
/// <param name="Svg">One svg element. It uses the page's colours, for example <c>var(--hold)</c>.</param>
sealed record FigureDrawing(string Title, string Description, string Svg);
