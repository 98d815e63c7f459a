namespace Nowpose.Cli.Figures.Model;

/// <summary>A drawing beside others, such as the arm at one moment.</summary>
/// <param name="Description">What is seen, in words, for who cannot see it.</param>
/// <param name="Svg">One svg element; colours are the page's, as <c>var(--hold)</c>.</param>
sealed record FigureDrawing(string Title, string Description, string Svg);
