using UnityEngine;

namespace Nowpose.Prefabs.Pictures;

/// <summary>The camera of a picture, with the projection of points in the world.</summary>
/// <param name="Place">Pose in the world, metres.</param>
/// <param name="HorizontalDegrees">Field of view over the picture's width.</param>
/// <param name="Width">Width of the picture, pixels.</param>
/// <param name="Height">Height of the picture, pixels.</param>
sealed record Eye(Pose Place, double HorizontalDegrees, int Width, int Height)
{
    /// <summary>Pixels of a length of 1 at a distance of 1.</summary>
    double Focus => Width / 2.0 / Math.Tan(HorizontalDegrees / 2 * Math.PI / 180);

    /// <summary>Distance along the line of sight, metres.</summary>
    public double Depth(Vector3 point) => (Quaternion.Inverse(Place.rotation) * (point - Place.position)).z;

    public (double X, double Y) Project(Vector3 point)
    {
        var seen = Quaternion.Inverse(Place.rotation) * (point - Place.position);
        return (Width / 2.0 + Focus * seen.x / seen.z, Height / 2.0 - Focus * seen.y / seen.z);
    }

    /// <summary>Pixels of a length in the world.</summary>
    public double Size(double metres, Vector3 at) => Focus * metres / Depth(at);
}
