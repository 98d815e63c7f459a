using System.Globalization;

namespace UnityEngine;

public struct Vector3(float x, float y, float z) : IEquatable<Vector3>, IFormattable
{
    public const float kEpsilon = 1E-05f;
    public const float kEpsilonNormalSqrt = 1E-15f;

    // Square of the distance below which == regards two vectors as equal.
    internal const float EqualitySquared = kEpsilon * kEpsilon;

    public float x = x;
    public float y = y;
    public float z = z;

    public Vector3(float x, float y) : this(x, y, 0) { }

    public static Vector3 zero => new(0, 0, 0);
    public static Vector3 one => new(1, 1, 1);
    public static Vector3 forward => new(0, 0, 1);
    public static Vector3 back => new(0, 0, -1);
    public static Vector3 up => new(0, 1, 0);
    public static Vector3 down => new(0, -1, 0);
    public static Vector3 right => new(1, 0, 0);

    public readonly float sqrMagnitude => x * x + y * y + z * z;
    public readonly float magnitude => MathF.Sqrt(sqrMagnitude);
    public readonly Vector3 normalized => Normalize(this);

    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
    public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;
    public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);
    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t) => a + (b - a) * t;

    public static Vector3 Min(Vector3 lhs, Vector3 rhs) =>
        new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));

    public static Vector3 Max(Vector3 lhs, Vector3 rhs) =>
        new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);

    public static Vector3 Normalize(Vector3 value)
    {
        var length = value.magnitude;
        return length > kEpsilon ? value / length : zero;
    }

    public static float Angle(Vector3 from, Vector3 to)
    {
        var lengths = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return lengths < kEpsilonNormalSqrt ? 0 : MathF.Acos(Mathf.Clamp(Dot(from, to) / lengths, -1, 1)) * Mathf.Rad2Deg;
    }

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);
    public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator *(float d, Vector3 a) => a * d;
    public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);
    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < EqualitySquared;
    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

    public readonly bool Equals(Vector3 other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z);
    public override readonly bool Equals(object other) => other is Vector3 v && Equals(v);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string format) => ToString(format, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F2" : format;
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
    }
}
