using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>A line style in a picture. The values match the light theme of the page (<c>Web/src/report.css</c>, <c>looks.ts</c>).</summary>
readonly record struct PictureInk(string Colour, double Width, string Dash)
{
    public string Stroke => FormattableString.Invariant($"stroke=\"{Colour}\" stroke-width=\"{Width}\"") + (Dash.Length > 0 ? $" stroke-dasharray=\"{Dash}\"" : "");

    public static PictureInk Of(string look) => look switch
    {
        Looks.Truth => new("#8a95a0", 5, ""),
        Looks.Hold => new("#d9741a", 1.5, "5 3"),
        Looks.Adaptive => new("#0b4a8f", 2.5, ""),
        Looks.Process => new("#b3261e", 2, "4 2"),
        Looks.Quadratic => new("#00856f", 2, "9 3"),
        Looks.Cubic => new("#a8478f", 2, "8 3 2 3"),
        _ => new("#6b7480", 1.5, "2 3"),
    };
}
