namespace Nowpose.Vision;

/// <summary>A rectangle in a picture, px from the top left corner.</summary>
public readonly record struct PictureBox(int X, int Y, int Width, int Height);
