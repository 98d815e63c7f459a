using System.Globalization;

namespace UnityEngine;

public struct Vector2(float x, float y) : IEquatable<Vector2>, IFormattable
{
    public float x = x;
    public float y = y;

    public static Vector2 zero => new(0, 0);

    public readonly float sqrMagnitude => x * x + y * y;

    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.x - b.x, a.y - b.y);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < Vector3.EqualitySquared;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector3(Vector2 v) => new(v.x, v.y, 0);

    public readonly bool Equals(Vector2 other) => x.Equals(other.x) && y.Equals(other.y);
    public override readonly bool Equals(object other) => other is Vector2 v && Equals(v);
    public override readonly int GetHashCode() => HashCode.Combine(x, y);

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F2" : format;
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
    }
}
