using System.Globalization;

namespace UnityEngine;

public struct Rect(float x, float y, float width, float height) : IEquatable<Rect>, IFormattable
{
    public float x { readonly get; set; } = x;
    public float y { readonly get; set; } = y;
    public float width { readonly get; set; } = width;
    public float height { readonly get; set; } = height;

    public float xMin
    {
        readonly get => x;
        set => (x, width) = (value, xMax - value);
    }

    public float xMax
    {
        readonly get => x + width;
        set => width = value - x;
    }

    public float yMin
    {
        readonly get => y;
        set => (y, height) = (value, yMax - value);
    }

    public float yMax
    {
        readonly get => y + height;
        set => height = value - y;
    }

    public readonly bool Equals(Rect other) =>
        x.Equals(other.x) && y.Equals(other.y) && width.Equals(other.width) && height.Equals(other.height);

    public override readonly bool Equals(object other) => other is Rect r && Equals(r);
    public override readonly int GetHashCode() => HashCode.Combine(x, y, width, height);

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F2" : format;
        formatProvider ??= CultureInfo.InvariantCulture;
        return $"(x:{x.ToString(format, formatProvider)}, y:{y.ToString(format, formatProvider)}, " +
            $"width:{width.ToString(format, formatProvider)}, height:{height.ToString(format, formatProvider)})";
    }
}
