using Nowpose.VisibleLight;

namespace Nowpose.Vision;

/// <summary>A code that was found in a picture.</summary>
/// <param name="Levels">Light of each cell in the order of <see cref="TimestampCode"/>, without what is behind it; linear, 1 is white.</param>
/// <param name="Corners">px, y down: x and y of the top left corner as the code is read, then clockwise.</param>
public sealed record FoundCode(CodeKind Kind, IReadOnlyList<double> Levels, IReadOnlyList<(double X, double Y)> Corners)
{
    /// <summary>Where in the picture a point of the code is, px from the top.</summary>
    /// <param name="column">0 at the left edge of the code to <see cref="TimestampCode.Side"/> at the right one.</param>
    public double HeightOf(double column, double row)
    {
        double u = column / TimestampCode.Side, v = row / TimestampCode.Side;
        return (1 - v) * ((1 - u) * Corners[0].Y + u * Corners[1].Y) + v * ((1 - u) * Corners[3].Y + u * Corners[2].Y);
    }
}
