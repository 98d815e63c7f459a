using System;
using System.Globalization;

namespace UnityEngine;

public struct Vector2 : IEquatable<Vector2>, IFormattable
{
    public float x;
    public float y;

    public Vector2(float x, float y)
    {
        this.x = x;
        this.y = y;
    }

    public static Vector2 zero => new(0, 0);
    public static Vector2 one => new(1, 1);
    public static Vector2 up => new(0, 1);
    public static Vector2 down => new(0, -1);
    public static Vector2 left => new(-1, 0);
    public static Vector2 right => new(1, 0);

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, _ => throw new IndexOutOfRangeException("Invalid Vector2 index!") };
        set
        {
            if (index == 0) x = value;
            else if (index == 1) y = value;
            else throw new IndexOutOfRangeException("Invalid Vector2 index!");
        }
    }

    public readonly float sqrMagnitude => x * x + y * y;
    public readonly float magnitude => MathF.Sqrt(sqrMagnitude);
    public readonly Vector2 normalized => magnitude > Vector3.kEpsilon ? this / magnitude : zero;

    public static float Dot(Vector2 lhs, Vector2 rhs) => lhs.x * rhs.x + lhs.y * rhs.y;
    public static float Distance(Vector2 a, Vector2 b) => (a - b).magnitude;
    public static Vector2 Lerp(Vector2 a, Vector2 b, float t) => a + (b - a) * Mathf.Clamp01(t);
    public static Vector2 Scale(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static Vector2 Min(Vector2 lhs, Vector2 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y));
    public static Vector2 Max(Vector2 lhs, Vector2 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y));

    public void Set(float newX, float newY) => this = new Vector2(newX, newY);

    public static Vector2 operator +(Vector2 a, Vector2 b) => new(a.x + b.x, a.y + b.y);
    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.x - b.x, a.y - b.y);
    public static Vector2 operator -(Vector2 a) => new(-a.x, -a.y);
    public static Vector2 operator *(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static Vector2 operator *(Vector2 a, float d) => new(a.x * d, a.y * d);
    public static Vector2 operator *(float d, Vector2 a) => a * d;
    public static Vector2 operator /(Vector2 a, float d) => new(a.x / d, a.y / d);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < Vector3.EqualitySquared;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector2(Vector3 v) => new(v.x, v.y);
    public static implicit operator Vector3(Vector2 v) => new(v.x, v.y, 0);

    public readonly bool Equals(Vector2 other) => x.Equals(other.x) && y.Equals(other.y);
    public override readonly bool Equals(object other) => other is Vector2 v && Equals(v);
    public override readonly int GetHashCode() => HashCode.Combine(x, y);

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string format) => ToString(format, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F2" : format;
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
    }
}
