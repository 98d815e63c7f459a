using System;

namespace UnityEngine;

public struct Ray : IFormattable
{
    Vector3 _direction;

    public Ray(Vector3 origin, Vector3 direction)
    {
        this.origin = origin;
        _direction = direction.normalized;
    }

    public Vector3 origin { readonly get; set; }

    public Vector3 direction
    {
        readonly get => _direction;
        set => _direction = value.normalized;
    }

    public readonly Vector3 GetPoint(float distance) => origin + _direction * distance;

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string format) => ToString(format, null);

    public readonly string ToString(string format, IFormatProvider formatProvider) =>
        $"Origin: {origin.ToString(format, formatProvider)}, Dir: {_direction.ToString(format, formatProvider)}";
}
