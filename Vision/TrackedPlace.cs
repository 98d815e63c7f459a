namespace Nowpose.Vision;

/// <summary>Centre of a tracked patch, px from the top left corner of the picture.</summary>
/// <param name="Score">Normalised correlation with the patch in the first picture; 1 for identical patches.</param>
public readonly record struct TrackedPlace(double X, double Y, double Score);
