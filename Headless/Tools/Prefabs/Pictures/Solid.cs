namespace Nowpose.Prefabs.Pictures;

/// <summary>
/// Creates the faces of Unity's built-in meshes, which the stand-in engine lacks. Each face is a convex polygon in the mesh's frame.
/// </summary>
static class Solid
{
    const int Sides = 32, Rings = 10;

    static readonly Vector3[] Square = [new(-0.5f, -0.5f, 0), new(0.5f, -0.5f, 0), new(0.5f, 0.5f, 0), new(-0.5f, 0.5f, 0)];

    /// <summary>Gets the faces of a mesh by its name; empty for an unknown mesh.</summary>
    public static IEnumerable<Vector3[]> Faces(string mesh) => mesh switch
    {
        "Cube" => Cube(),
        "Cylinder" => Cylinder(),
        "Sphere" => Sphere(),
        "Quad" => [Square],
        _ => [],
    };

    static IEnumerable<Vector3[]> Cube()
    {
        foreach (var turn in new[] { Quaternion.identity, Quaternion.Euler(0, 90, 0), Quaternion.Euler(90, 0, 0) })
            foreach (var side in new[] { -0.5f, 0.5f })
                yield return [.. Square.Select(corner => turn * (corner + side * Vector3.forward))];
    }

    // A cylinder of radius 0.5 and height 2.
    static IEnumerable<Vector3[]> Cylinder()
    {
        for (var i = 0; i < Sides; i++) yield return [OnSide(i, -1), OnSide(i + 1, -1), OnSide(i + 1, 1), OnSide(i, 1)];
        foreach (var end in new[] { -1, 1 }) yield return [.. Enumerable.Range(0, Sides).Select(i => OnSide(i, end))];
    }

    static Vector3 OnSide(int i, float y) => OnRing(i, 0.5f, y);

    static IEnumerable<Vector3[]> Sphere()
    {
        for (var ring = 0; ring < Rings; ring++)
            for (var i = 0; i < Sides; i++) yield return [OnSphere(i, ring), OnSphere(i + 1, ring), OnSphere(i + 1, ring + 1), OnSphere(i, ring + 1)];
    }

    static Vector3 OnSphere(int i, int ring)
    {
        var latitude = Mathf.PI * ring / Rings;
        return OnRing(i, 0.5f * Mathf.Sin(latitude), 0.5f * Mathf.Cos(latitude));
    }

    static Vector3 OnRing(int i, float radius, float y)
    {
        var angle = 2 * Mathf.PI * i / Sides;
        return new Vector3(radius * Mathf.Cos(angle), y, radius * Mathf.Sin(angle));
    }
}
