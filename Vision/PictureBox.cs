namespace Nowpose.Vision;

/// <summary>A part of a picture, px from its top left corner.</summary>
public readonly record struct PictureBox(int X, int Y, int Width, int Height);
