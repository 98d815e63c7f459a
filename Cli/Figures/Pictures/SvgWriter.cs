using System.Text;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Writes the elements of an SVG file. Numbers are written with a point.</summary>
sealed class SvgWriter
{
    public const string Ink = "#16202c", Muted = "#55616f", Font = "font-family=\"system-ui, sans-serif\"";

    readonly StringBuilder _svg = new();

    /// <summary>Begins a picture with a white background.</summary>
    /// <param name="label">Description of the picture for screen readers.</param>
    public SvgWriter(int width, int height, string label)
    {
        Add($"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\" ");
        Add($"aria-label=\"{label}\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n");
    }

    public void Add(FormattableString text) => _svg.Append(FormattableString.Invariant(text));

    public void Text(double x, double y, string anchor, string text, string colour = Muted) =>
        Add($"<text x=\"{x:0.#}\" y=\"{y:0.#}\" text-anchor=\"{anchor}\" fill=\"{colour}\" {Font} font-size=\"12\">{text}</text>\n");

    /// <summary>Ends the picture and returns the file.</summary>
    public string Finish() => _svg.Append("</svg>\n").ToString();
}
