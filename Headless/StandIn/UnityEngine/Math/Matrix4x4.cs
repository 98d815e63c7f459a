namespace UnityEngine;

/// <summary>A 4x4 matrix with elements m[row, column]. It multiplies column vectors.</summary>
public struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
{
    public float m00;
    public float m10;
    public float m20;
    public float m30;
    public float m01;
    public float m11;
    public float m21;
    public float m31;
    public float m02;
    public float m12;
    public float m22;
    public float m32;
    public float m03;
    public float m13;
    public float m23;
    public float m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        (m00, m10, m20, m30) = (column0.x, column0.y, column0.z, column0.w);
        (m01, m11, m21, m31) = (column1.x, column1.y, column1.z, column1.w);
        (m02, m12, m22, m32) = (column2.x, column2.y, column2.z, column2.w);
        (m03, m13, m23, m33) = (column3.x, column3.y, column3.z, column3.w);
    }

    public static Matrix4x4 identity => new(new Vector4(1, 0, 0, 0), new Vector4(0, 1, 0, 0), new Vector4(0, 0, 1, 0), new Vector4(0, 0, 0, 1));

    public readonly Vector4 GetColumn(int index) => index switch
    {
        0 => new Vector4(m00, m10, m20, m30),
        1 => new Vector4(m01, m11, m21, m31),
        2 => new Vector4(m02, m12, m22, m32),
        3 => new Vector4(m03, m13, m23, m33),
        _ => throw new IndexOutOfRangeException("Invalid column index!"),
    };

    public readonly Vector4 GetRow(int index) => index switch
    {
        0 => new Vector4(m00, m01, m02, m03),
        1 => new Vector4(m10, m11, m12, m13),
        2 => new Vector4(m20, m21, m22, m23),
        3 => new Vector4(m30, m31, m32, m33),
        _ => throw new IndexOutOfRangeException("Invalid row index!"),
    };

    public readonly Vector3 GetPosition() => new(m03, m13, m23);

    public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s) => new(
        q * Vector3.right * s.x,
        q * Vector3.up * s.y,
        q * Vector3.forward * s.z,
        new Vector4(pos.x, pos.y, pos.z, 1));

    public static Matrix4x4 Rotate(Quaternion q) => TRS(Vector3.zero, q, Vector3.one);

    public readonly Vector3 MultiplyPoint3x4(Vector3 point) => MultiplyVector(point) + GetPosition();

    public readonly Vector3 MultiplyVector(Vector3 vector) => new(
        m00 * vector.x + m01 * vector.y + m02 * vector.z,
        m10 * vector.x + m11 * vector.y + m12 * vector.z,
        m20 * vector.x + m21 * vector.y + m22 * vector.z);

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new(
        Vector4.Dot(lhs.GetRow(0), vector), Vector4.Dot(lhs.GetRow(1), vector),
        Vector4.Dot(lhs.GetRow(2), vector), Vector4.Dot(lhs.GetRow(3), vector));

    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) =>
        new(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) =>
        lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1) &&
        lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

    public readonly bool Equals(Matrix4x4 other) =>
        GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1)) &&
        GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));

    public override readonly bool Equals(object other) => other is Matrix4x4 m && Equals(m);
    public override readonly int GetHashCode() => HashCode.Combine(GetColumn(0), GetColumn(1), GetColumn(2), GetColumn(3));

    public override readonly string ToString() => ToString(null, null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        format = string.IsNullOrEmpty(format) ? "F5" : format;
        return string.Join("\n",
            GetRow(0).ToString(format, formatProvider), GetRow(1).ToString(format, formatProvider),
            GetRow(2).ToString(format, formatProvider), GetRow(3).ToString(format, formatProvider));
    }
}
