using System.Globalization;

namespace UnityEngine;

public struct Vector4(float x, float y, float z, float w) : IEquatable<Vector4>, IFormattable
{
    public float x = x;
    public float y = y;
    public float z = z;
    public float w = w;

    public readonly float sqrMagnitude => Dot(this, this);

    public static float Dot(Vector4 a, Vector4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

    public static Vector4 operator -(Vector4 a, Vector4 b) => new(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
    public static bool operator ==(Vector4 lhs, Vector4 rhs) => (lhs - rhs).sqrMagnitude < Vector3.EqualitySquared;
    public static bool operator !=(Vector4 lhs, Vector4 rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Vector3 v) => new(v.x, v.y, v.z, 0);
    public static implicit operator Vector3(Vector4 v) => new(v.x, v.y, v.z);

    public readonly bool Equals(Vector4 other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);
    public override readonly bool Equals(object other) => other is Vector4 v && Equals(v);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F2" : format;
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, " +
            $"{z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
    }
}
