using System.Text;
using System.Text.RegularExpressions;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Creates an SVG file with the drawings of Fig. 17 side by side. Replaces the page's colours with fixed light ones.</summary>
static partial class ArmPicture
{
    const int Width = 320, Height = 264, TitleHeight = 24;

    public static string Of(IReadOnlyList<FigureDrawing> drawings)
    {
        var svg = new StringBuilder();
        var size = $"width=\"{Width * drawings.Count}\" height=\"{Height + TitleHeight}\"";
        svg.Append($"<svg xmlns=\"http://www.w3.org/2000/svg\" {size} role=\"img\" aria-label=\"{string.Join(" ", drawings.Select(d => d.Description))}\">\n");
        svg.Append($"<rect {size} fill=\"#fff\"/>\n");
        for (var i = 0; i < drawings.Count; i++)
        {
            svg.Append($"<text x=\"{Width * i + 10}\" y=\"18\" fill=\"#16202c\" font-family=\"system-ui, sans-serif\" font-size=\"14\" font-weight=\"600\">{drawings[i].Title}</text>\n");
            svg.Append(Light(drawings[i].Svg).Replace("<svg ", $"<svg x=\"{Width * i}\" y=\"{TitleHeight}\" width=\"{Width}\" height=\"{Height}\" ", StringComparison.Ordinal)).Append('\n');
        }
        return svg.Append("</svg>\n").ToString();
    }

    static string Light(string svg) => Variable().Replace(svg, match => match.Groups[1].Value switch
    {
        "ink" => "#16202c",
        "muted" => "#55616f",
        "surface" => "#fff",
        var look => PictureInk.Of(look).Colour,
    });

    [GeneratedRegex(@"var\(--(\w+)\)")]
    private static partial Regex Variable();
}
