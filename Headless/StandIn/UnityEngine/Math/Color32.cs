namespace UnityEngine;

public struct Color32(byte r, byte g, byte b, byte a) : IFormattable
{
    public byte r = r;
    public byte g = g;
    public byte b = b;
    public byte a = a;

    public static implicit operator Color32(Color c) => new(Byte(c.r), Byte(c.g), Byte(c.b), Byte(c.a));
    public static implicit operator Color(Color32 c) => new(c.r / 255f, c.g / 255f, c.b / 255f, c.a / 255f);

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        $"RGBA({r.ToString(format, formatProvider)}, {g.ToString(format, formatProvider)}, " +
        $"{b.ToString(format, formatProvider)}, {a.ToString(format, formatProvider)})";

    static byte Byte(float value) => (byte)MathF.Round(Mathf.Clamp01(value) * 255);
}
