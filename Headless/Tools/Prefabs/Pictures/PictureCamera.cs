namespace Nowpose.Prefabs.Pictures;

/// <summary>The camera of a picture. Projects points of the world to the picture.</summary>
/// <param name="Place">Pose of the camera in the world, metres.</param>
/// <param name="HorizontalDegrees">Horizontal field of view, degrees.</param>
/// <param name="Width">Width of the picture, pixels.</param>
/// <param name="Height">Height of the picture, pixels.</param>
sealed record PictureCamera(Pose Place, double HorizontalDegrees, int Width, int Height)
{
    /// <summary>Focal length in pixels: the length in the picture of an object of 1 m at a distance of 1 m.</summary>
    double Focus => Width / 2.0 / Math.Tan(HorizontalDegrees / 2 * Math.PI / 180);

    /// <summary>Gets the distance of a point along the line of sight, metres.</summary>
    public double Depth(Vector3 point) => (Quaternion.Inverse(Place.rotation) * (point - Place.position)).z;

    public (double X, double Y) Project(Vector3 point)
    {
        var seen = Quaternion.Inverse(Place.rotation) * (point - Place.position);
        return (Width / 2.0 + Focus * seen.x / seen.z, Height / 2.0 - Focus * seen.y / seen.z);
    }

    /// <summary>Converts a length in the world to its length in the picture, in pixels.</summary>
    public double Size(double metres, Vector3 at) => Focus * metres / Depth(at);
}
