using Nowpose.Latency;

namespace Nowpose.Vision;

/// <summary>A code that was found in a picture.</summary>
/// <param name="Levels">Light of each cell without the background, in the order of <see cref="TimestampCode"/>; linear, 1 is white.</param>
/// <param name="Corners">Corners in px, y down. The first is the top left corner of the code; the others follow clockwise.</param>
sealed record FoundCode(CodeKind Kind, IReadOnlyList<double> Levels, IReadOnlyList<(double X, double Y)> Corners)
{
    /// <summary>Share of the cells whose middle is white, 0 to 1.</summary>
    public double WhiteShare { get; init; }

    /// <summary>
    /// 90th percentile of the residuals of the light model at the edges between cells, relative to the light of a lit cell.
    /// </summary>
    public double Residual { get; init; }

    /// <summary>Whether a better match of this kind exists and this match is weak, so that it may be an object other than a code.</summary>
    public bool IsWeak { get; init; }

    /// <summary>Centre of the code, px: the intersection of the diagonals, which is correct even in perspective.</summary>
    public (double X, double Y) Center
    {
        get
        {
            var (a, b, c, d) = (Corners[0], Corners[1], Corners[2], Corners[3]);
            double acX = c.X - a.X, acY = c.Y - a.Y, bdX = d.X - b.X, bdY = d.Y - b.Y;
            var share = ((b.X - a.X) * bdY - (b.Y - a.Y) * bdX) / (acX * bdY - acY * bdX);
            return (a.X + share * acX, a.Y + share * acY);
        }
    }

    /// <summary>Mean length of the four sides, px.</summary>
    public double Side => Enumerable.Range(0, 4).Average(i => Distance(Corners[i], Corners[(i + 1) % 4]));

    /// <summary>Returns the vertical position of a point of the code in the picture, px from the top.</summary>
    /// <param name="column">Position in cells, from 0 at the left edge of the code to <see cref="TimestampCode.Side"/> at the right edge.</param>
    public double HeightOf(double column, double row)
    {
        double u = column / TimestampCode.Side, v = row / TimestampCode.Side;
        return (1 - v) * ((1 - u) * Corners[0].Y + u * Corners[1].Y) + v * ((1 - u) * Corners[3].Y + u * Corners[2].Y);
    }

    static double Distance((double X, double Y) a, (double X, double Y) b) => Math.Sqrt((a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y));
}
