namespace Nowpose.Prefabs.Pictures;

/// <summary>A convex polygon in the world. Each corner has a phase that determines the stripes.</summary>
sealed record Face((Vector3 Point, float Phase)[] Corners, Color Colour, double Opacity, bool IsStriped)
{
    public Vector3 Centre => Corners.Aggregate(Vector3.zero, (sum, c) => sum + c.Point) / Corners.Length;

    /// <summary>
    /// Returns the parts of the face that lie in the stripes, which have reduced opacity, or those in the gaps between the stripes.
    /// </summary>
    public IEnumerable<Vector3[]> Stripes(bool fainter)
    {
        var (first, last) = ((int)Math.Floor(Corners.Min(c => c.Phase)), (int)Math.Floor(Corners.Max(c => c.Phase)));
        for (var i = first; i <= last; i++)
        {
            var from = i + (fainter ? 0.5f : 0);
            var part = Clip(Clip(Corners, from, 1), from + 0.5f, -1);
            if (part.Length > 2) yield return [.. part.Select(c => c.Point)];
        }
    }

    // Keeps the part of a polygon whose phase is above a limit (sign 1) or below it (sign -1).
    static (Vector3 Point, float Phase)[] Clip((Vector3 Point, float Phase)[] corners, float limit, int sign)
    {
        var kept = new List<(Vector3, float)>();
        for (var i = 0; i < corners.Length; i++)
        {
            var (a, b) = (corners[i], corners[(i + 1) % corners.Length]);
            var (isIn, isNextIn) = (sign * (a.Phase - limit) >= 0, sign * (b.Phase - limit) >= 0);
            if (isIn) kept.Add(a);
            if (isIn != isNextIn) kept.Add((Vector3.Lerp(a.Point, b.Point, (limit - a.Phase) / (b.Phase - a.Phase)), limit));
        }
        return [.. kept];
    }
}
