using System.Globalization;
using System.Xml.Linq;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.ControlSystem;

/// <summary>Compares the manual's drawing of the LED matrix with reference codes that another program computed.</summary>
public class LedMatrixPictureTests
{
    const int ShownMs = 12_345;

    static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    [TestCase("control")]
    [TestCase("headset")]
    public void LedMatrix_LitSquares_EqualTheReferenceFile(string kind)
    {
        var expected = CodeVectors.Read().Single(row => row.Kind == kind && row.ValueMs == ShownMs).Rows;

        Assert.That(RowsOf(kind, "#fff"), Is.EqualTo(expected));
    }

    [Test]
    public void LedMatrix_RingAndPairs_CoverTheBoard()
    {
        byte[] ring = [0x9f, 0x81, 0x81, 0x81, 0x81, 0x81, 0x81, 0xff];

        Assert.That(RowsOf("board", "#fff"), Is.EqualTo(ring));
        Assert.That(RowsOf("board", "#9ccbff"), Is.EqualTo(new byte[] { 0, 0x7e, 0x7e, 0x7e, 0x7e, 0x7e, 0x7e, 0 }));
    }

    /// <summary>Returns the squares of one colour as rows of bits. The leftmost square is the highest bit.</summary>
    static byte[] RowsOf(string group, string colour)
    {
        var picture = XDocument.Parse(RepositoryFiles.Read($"{RepositoryFiles.Package}/Documentation~/images/led-matrix.svg"));
        var all = picture.Descendants(Svg + "g").Single(g => (string)g.Attribute("id") == group).Elements(Svg + "rect").ToList();
        double left = all.Min(X), top = all.Min(Y), pitch = (all.Max(X) - left) / 7;
        var rows = new byte[8];
        foreach (var square in all.Where(square => (string)square.Attribute("fill") == colour))
            rows[(int)Math.Round((Y(square) - top) / pitch)] |= (byte)(0x80 >> (int)Math.Round((X(square) - left) / pitch));
        return rows;
    }

    static double X(XElement square) => double.Parse(square.Attribute("x")!.Value, CultureInfo.InvariantCulture);

    static double Y(XElement square) => double.Parse(square.Attribute("y")!.Value, CultureInfo.InvariantCulture);
}
