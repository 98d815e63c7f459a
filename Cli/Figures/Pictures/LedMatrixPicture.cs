using Nowpose.Cli.Messages;
using Nowpose.Latency;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>
/// Draws the manual's picture of the LED matrix from <see cref="TimestampCode"/>: the front of the board with dimensions and outputs, and
/// the code of one time as shown by the control system and by the headset.
/// </summary>
static class LedMatrixPicture
{
    public const string File = "led-matrix.svg";

    /// <summary>Time for which both codes are drawn.</summary>
    public const int ShownMs = 12_345;

    const int Top = 66, Board = 34, BoardLeft = 62, Code = 24, ControlLeft = 490, HeadsetLeft = 750;
    const int Width = HeadsetLeft + 10 * Code + 12, Height = Top + 10 * Board + 56;

    /// <summary>Side of an LED's diffuser, in pitches. The squares of a headset's code have no gaps.</summary>
    const double Diffuser = 0.8;

    const string Lit = "#fff", Pair = "#9ccbff", Dark = "#3a4653";

    public static string Draw()
    {
        var svg = new SvgWriter(Width, Height, LedMatrixTexts.Label);
        DrawBoard(svg);
        Dimensions(svg);
        DrawCode(svg, "control", CodeKind.Control, ControlLeft, Diffuser, "control system, 12 345 ms");
        DrawCode(svg, "headset", CodeKind.Headset, HeadsetLeft, 1, "headset, 12 345 ms");
        Captions(svg, ControlLeft, LedMatrixTexts.TopMarks, LedMatrixTexts.Pairs);
        Captions(svg, HeadsetLeft, LedMatrixTexts.RightMarks, LedMatrixTexts.NoMargin);
        return svg.Finish();
    }

    static void DrawBoard(SvgWriter svg)
    {
        Background(svg, BoardLeft, Board, LedMatrixTexts.Front);
        svg.Add($"<g id=\"board\">\n");
        for (var cell = 0; cell < TimestampCode.CellCount; cell++)
            if (TimestampCode.IsRing(cell)) Cell(svg, cell, BoardLeft, Board, Diffuser, TimestampCode.IsLitRing(cell, CodeKind.Control) ? Lit : Dark);
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            Cell(svg, cell, BoardLeft, Board, Diffuser, Pair);
            Cell(svg, cell + 1, BoardLeft, Board, Diffuser, Pair);
            svg.Text(Left(cell, BoardLeft, Board) + Board / 2.0, Up(cell, Board) + Board / 2.0 + 4, "middle", NameOf(pair), SvgWriter.Ink, 11);
        }
        svg.Add($"</g>\n");
        for (var i = 0; i < TimestampCode.Side; i++)
        {
            svg.Text(Left(i, BoardLeft, Board) + Board / 2.0, Top - 6, "middle", FormattableString.Invariant($"{TimestampCode.Side - 1 - i}"));
            svg.Text(BoardLeft - 6, Up(i * TimestampCode.Side, Board) + Board / 2.0 + 4, "end", FormattableString.Invariant($"byte {i}"));
        }
        svg.Text(BoardLeft - 6, Top - 6, "end", "bit");
    }

    static void Captions(SvgWriter svg, int left, params string[] lines)
    {
        for (var i = 0; i < lines.Length; i++) svg.Text(left + 5 * Code, Top + 10 * Code + 22 + 18 * i, "middle", lines[i]);
    }

    static string NameOf(int pair) => pair < TimestampCode.ValueBits
        ? FormattableString.Invariant($"g{TimestampCode.ValueBits - 1 - pair}")
        : pair == TimestampCode.ValueBits ? "even" : "odd";

    /// <summary>Draws the dimensions pitch, side and margin below the board.</summary>
    static void Dimensions(SvgWriter svg)
    {
        const int Bottom = Top + 10 * Board;
        double first = Left(0, BoardLeft, Board), middle = first + Board / 2.0, last = first + TimestampCode.Side * Board;
        Dimension(svg, middle, middle + Board, Bottom + 12, "p");
        Dimension(svg, last, last + Board, Bottom + 12, "margin p");
        Dimension(svg, first, last, Bottom + 30, "8 p = 60 mm to 100 mm");
    }

    static void Dimension(SvgWriter svg, double from, double to, double y, string text)
    {
        svg.Add($"<path d=\"M{from:0.#} {y - 5:0.#}v10M{to:0.#} {y - 5:0.#}v10M{from:0.#} {y:0.#}H{to:0.#}\" stroke=\"{SvgWriter.Muted}\"/>\n");
        var isWide = to - from > 4 * Board;
        svg.Text(isWide ? (from + to) / 2 : to + 5, isWide ? y + 16 : y + 4, isWide ? "middle" : "start", text);
    }

    static void DrawCode(SvgWriter svg, string name, CodeKind kind, int left, double size, string title)
    {
        var cells = new bool[TimestampCode.CellCount];
        TimestampCode.Draw(ShownMs, kind, cells);
        Background(svg, left, Code, title);
        svg.Add($"<g id=\"{name}\">\n");
        for (var cell = 0; cell < cells.Length; cell++)
            if (cells[cell]) Cell(svg, cell, left, Code, size, Lit);
        svg.Add($"</g>\n");
    }

    static void Background(SvgWriter svg, int left, int pitch, string title)
    {
        svg.Text(left + 5 * pitch, 24, "middle", title, SvgWriter.Ink, 14);
        svg.Add($"<rect x=\"{left}\" y=\"{Top}\" width=\"{10 * pitch}\" height=\"{10 * pitch}\" fill=\"{SvgWriter.Ink}\"/>\n");
    }

    static void Cell(SvgWriter svg, int cell, int left, int pitch, double size, string colour)
    {
        double gap = (1 - size) / 2 * pitch, side = size * pitch;
        svg.Add($"<rect x=\"{Left(cell, left, pitch) + gap:0.#}\" y=\"{Up(cell, pitch) + gap:0.#}\" width=\"{side:0.#}\" height=\"{side:0.#}\" ");
        svg.Add($"fill=\"{colour}\"/>\n");
    }

    static int Left(int cell, int left, int pitch) => left + pitch + cell % TimestampCode.Side * pitch;

    static int Up(int cell, int pitch) => Top + pitch + cell / TimestampCode.Side * pitch;
}
