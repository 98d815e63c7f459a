namespace Nowpose.Vision;

/// <summary>Centre of a patch, px from the picture's top left corner.</summary>
/// <param name="Score">Normalised correlation with the patch of the first picture; 1 if they are identical.</param>
public readonly record struct TrackedPlace(double X, double Y, double Score);
