using System.Globalization;
using System.Text;
using QRCoder;

namespace Nowpose.Gateway.Codes;

/// <summary>
/// Encodes text as a QR code: the smallest version that fits at error correction level M, with the required quiet zone of four modules.
/// </summary>
sealed class QrCode : IDisposable
{
    const int Margin = 4;

    readonly string _text;
    readonly QRCodeData _data;

    public QrCode(string text)
    {
        _text = text;
        _data = Generate(text);
    }

    /// <summary>Number of modules along one edge, without the margin.</summary>
    public int Modules => Edge - 2 * Margin;

    /// <summary>Whether a module is dark; indices include the margin.</summary>
    public bool IsDark(int row, int column) => row < Edge && _data.ModuleMatrix[row][column];

    /// <summary>Number of modules along one edge, with the margin.</summary>
    public int Edge => _data.ModuleMatrix.Count;

    /// <summary>
    /// Gets the code as text for a terminal, two rows of modules per line: black on white if colours are supported, else light on dark.
    /// </summary>
    public string Blocks(bool hasColours)
    {
        var text = new StringBuilder();
        for (var row = 0; row < Edge; row += 2)
        {
            // Sets black on white independently of the terminal's own colours, because some readers refuse an inverted code.
            if (hasColours) text.Append("\u001b[30;107m");
            for (var column = 0; column < Edge; column++)
                text.Append(Block(IsInk(row, column, hasColours), IsInk(row + 1, column, hasColours)));
            if (hasColours) text.Append("\u001b[0m");
            text.Append('\n');
        }

        return text.ToString();
    }

    /// <summary>Gets the code as a drawing in millimetres.</summary>
    /// <param name="edgeMm">Edge length of the code without its margin.</param>
    /// <param name="caption">Title of the drawing, not escaped.</param>
    public string Svg(double edgeMm, string caption)
    {
        var squares = new StringBuilder();
        for (var row = 0; row < Edge; row++)
            for (var column = 0; column < Edge; column++)
                if (IsDark(row, column)) squares.Append(CultureInfo.InvariantCulture, $"M{column} {row}h1v1h-1z");
        var total = edgeMm * Edge / Modules;
        return string.Create(CultureInfo.InvariantCulture, $"""
            <svg xmlns="http://www.w3.org/2000/svg" width="{total:0.###}mm" height="{total:0.###}mm" viewBox="0 0 {Edge} {Edge}"
              shape-rendering="crispEdges">
            <title>{caption}</title>
            <rect width="{Edge}" height="{Edge}" fill="#fff"/>
            <path d="{squares}" fill="#000"/>
            </svg>

            """).ReplaceLineEndings("\n");
    }

    /// <summary>
    /// Gets the code as a picture. The picture has no physical size; print it with the width of the drawing from <see cref="Svg"/>.
    /// </summary>
    public byte[] Png(int pixelsPerModule)
    {
        // Generates the data again, because PngByteQRCode disposes its data.
        using var picture = new PngByteQRCode(Generate(_text));
        return picture.GetGraphic(pixelsPerModule);
    }

    public void Dispose() => _data.Dispose();

    static QRCodeData Generate(string text) => QRCodeGenerator.GenerateQrCode(text, QRCodeGenerator.ECCLevel.M);

    bool IsInk(int row, int column, bool hasColours) => hasColours ? IsDark(row, column) : row < Edge && !IsDark(row, column);

    static char Block(bool upper, bool lower) => (upper, lower) switch { (true, true) => '█', (true, false) => '▀', (false, true) => '▄', _ => ' ' };
}
