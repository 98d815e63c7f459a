namespace Nowpose.Vision;

/// <summary>Where the middle of a patch is, px from the picture's top left corner.</summary>
/// <param name="Score">Normalised correlation with the patch of the first picture: 1 where they are the same.</param>
public readonly record struct TrackedPlace(double X, double Y, double Score);
