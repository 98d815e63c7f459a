namespace UnityEngine;

public struct Bounds(Vector3 center, Vector3 size) : IEquatable<Bounds>, IFormattable
{
    public Vector3 center { readonly get; set; } = center;
    public Vector3 extents { readonly get; set; } = size / 2;

    public Vector3 size
    {
        readonly get => extents * 2;
        set => extents = value / 2;
    }

    public Vector3 min
    {
        readonly get => center - extents;
        set => SetMinMax(value, max);
    }

    public Vector3 max
    {
        readonly get => center + extents;
        set => SetMinMax(min, value);
    }

    public void SetMinMax(Vector3 min, Vector3 max)
    {
        extents = (max - min) / 2;
        center = min + extents;
    }

    public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

    public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.center == rhs.center && lhs.extents == rhs.extents;
    public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);

    public readonly bool Equals(Bounds other) => center.Equals(other.center) && extents.Equals(other.extents);
    public override readonly bool Equals(object other) => other is Bounds b && Equals(b);
    public override readonly int GetHashCode() => HashCode.Combine(center, extents);

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        $"Center: {center.ToString(format, formatProvider)}, Extents: {extents.ToString(format, formatProvider)}";
}
