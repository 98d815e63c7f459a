using System.Globalization;

namespace UnityEngine;

public struct Color(float r, float g, float b, float a) : IEquatable<Color>, IFormattable
{
    public float r = r;
    public float g = g;
    public float b = b;
    public float a = a;

    public Color(float r, float g, float b) : this(r, g, b, 1) { }

    public static Color white => new(1, 1, 1);
    public static Color red => new(1, 0, 0);
    public static Color green => new(0, 1, 0);
    public static Color blue => new(0, 0, 1);
    public static Color clear => new(0, 0, 0, 0);

    public static Color operator *(Color a, float b) => new(a.r * b, a.g * b, a.b * b, a.a * b);
    public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;
    public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Color c) => new(c.r, c.g, c.b, c.a);
    public static implicit operator Color(Vector4 v) => new(v.x, v.y, v.z, v.w);

    public readonly bool Equals(Color other) => ((Vector4)this).Equals(other);
    public override readonly bool Equals(object other) => other is Color c && Equals(c);
    public override readonly int GetHashCode() => ((Vector4)this).GetHashCode();

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        "RGBA" + ((Vector4)this).ToString(string.IsNullOrEmpty(format) ? "F3" : format, formatProvider ?? CultureInfo.InvariantCulture);
}
