namespace Nowpose.Vision;

/// <summary>A picture to be made. Lengths in px, light linear with 1 for white.</summary>
/// <param name="Scene">Seed of what is behind the codes.</param>
/// <param name="SceneLight">How bright that is: 1 as it was drawn.</param>
/// <param name="Blur">Standard deviation of the lens's blur.</param>
/// <param name="Motion">How far the camera moves during the exposure: x and y.</param>
/// <param name="Noise">Standard deviation of the sensor's noise, of 255.</param>
public sealed record Shot(
    int Width, int Height, int Scene, double SceneLight, IReadOnlyList<DrawnCode> Codes, double Blur, double[] Motion, IReadOnlyList<Glare> Glares,
    IReadOnlyList<Cover> Covers, double Noise, int NoiseSeed);

/// <summary>A code as the camera is to see it.</summary>
/// <param name="Corners">x and y of each: the top left one as the code is read, then clockwise.</param>
/// <param name="Lit">Of each cell, how much of the exposure it was lit: 0 to 1.</param>
/// <param name="Light">Of a lit cell.</param>
/// <param name="Dot">Diameter of round LEDs as a share of a cell; 0 for full squares.</param>
/// <param name="Panel">Light of the panel behind the cells; null for a hologram, which only adds to what is behind it.</param>
public sealed record DrawnCode(double[][] Corners, double[] Lit, double Light, double Dot, double? Panel);

/// <summary>A round reflection.</summary>
public sealed record Glare(double X, double Y, double Radius, double Light);

/// <summary>A rectangle in front of everything.</summary>
/// <param name="Box">x, y, width, height.</param>
public sealed record Cover(double[] Box, double Light);
