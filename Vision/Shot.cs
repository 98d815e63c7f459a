namespace Nowpose.Vision;

/// <summary>A picture to render. Lengths are in px; light is linear, 1 is white.</summary>
/// <param name="Scene">Seed of the background scene.</param>
/// <param name="SceneLight">Brightness factor of the background scene.</param>
/// <param name="Blur">Standard deviation of the lens blur, px.</param>
/// <param name="Motion">Motion of the camera during the exposure, x and y.</param>
/// <param name="Noise">Standard deviation of the sensor noise; 255 is white.</param>
public sealed record Shot(
    int Width, int Height, int Scene, double SceneLight, IReadOnlyList<DrawnCode> Codes, double Blur, double[] Motion, IReadOnlyList<Glare> Glares,
    IReadOnlyList<Cover> Covers, double Noise, int NoiseSeed);

/// <summary>A code as seen by the camera.</summary>
/// <param name="Corners">x and y of each corner. The first is the top left corner of the code; the others follow clockwise.</param>
/// <param name="Lit">Share of the exposure in which each cell is lit, 0 to 1.</param>
/// <param name="Light">Light of a lit cell; more than 1 is overexposed.</param>
/// <param name="Dot">Diameter of round LEDs relative to a cell; 0 for complete squares.</param>
/// <param name="Panel">Light of the panel behind the cells; null for a hologram, which only adds light to the background.</param>
public sealed record DrawnCode(double[][] Corners, double[] Lit, double Light, double Dot, double? Panel)
{
    /// <summary>Red, green and blue part of the light; null for white light.</summary>
    public double[] Colour { get; init; }
}

/// <summary>A round reflection.</summary>
public sealed record Glare(double X, double Y, double Radius, double Light);

/// <summary>A rectangle in front of all other objects.</summary>
/// <param name="Box">x, y, width and height.</param>
public sealed record Cover(double[] Box, double Light);
