namespace UnityEngine;

/// <summary>Determinant and inverse of four by four, from the two by two minors of its upper and lower half.</summary>
static class Cofactors
{
    internal static float Determinant(in Matrix4x4 m) => new Minors(m).Determinant;

    internal static Matrix4x4 Inverse(in Matrix4x4 m)
    {
        var n = new Minors(m);
        if (n.Determinant == 0) return Matrix4x4.zero;

        var d = 1 / n.Determinant;
        return new Matrix4x4(
            new Vector4(
                m.m11 * n.C5 - m.m12 * n.C4 + m.m13 * n.C3,
                -m.m10 * n.C5 + m.m12 * n.C2 - m.m13 * n.C1,
                m.m10 * n.C4 - m.m11 * n.C2 + m.m13 * n.C0,
                -m.m10 * n.C3 + m.m11 * n.C1 - m.m12 * n.C0) * d,
            new Vector4(
                -m.m01 * n.C5 + m.m02 * n.C4 - m.m03 * n.C3,
                m.m00 * n.C5 - m.m02 * n.C2 + m.m03 * n.C1,
                -m.m00 * n.C4 + m.m01 * n.C2 - m.m03 * n.C0,
                m.m00 * n.C3 - m.m01 * n.C1 + m.m02 * n.C0) * d,
            new Vector4(
                m.m31 * n.S5 - m.m32 * n.S4 + m.m33 * n.S3,
                -m.m30 * n.S5 + m.m32 * n.S2 - m.m33 * n.S1,
                m.m30 * n.S4 - m.m31 * n.S2 + m.m33 * n.S0,
                -m.m30 * n.S3 + m.m31 * n.S1 - m.m32 * n.S0) * d,
            new Vector4(
                -m.m21 * n.S5 + m.m22 * n.S4 - m.m23 * n.S3,
                m.m20 * n.S5 - m.m22 * n.S2 + m.m23 * n.S1,
                -m.m20 * n.S4 + m.m21 * n.S2 - m.m23 * n.S0,
                m.m20 * n.S3 - m.m21 * n.S1 + m.m22 * n.S0) * d);
    }

    readonly ref struct Minors
    {
        internal readonly float S0, S1, S2, S3, S4, S5, C0, C1, C2, C3, C4, C5;

        internal Minors(in Matrix4x4 m)
        {
            S0 = m.m00 * m.m11 - m.m10 * m.m01;
            S1 = m.m00 * m.m12 - m.m10 * m.m02;
            S2 = m.m00 * m.m13 - m.m10 * m.m03;
            S3 = m.m01 * m.m12 - m.m11 * m.m02;
            S4 = m.m01 * m.m13 - m.m11 * m.m03;
            S5 = m.m02 * m.m13 - m.m12 * m.m03;
            C5 = m.m22 * m.m33 - m.m32 * m.m23;
            C4 = m.m21 * m.m33 - m.m31 * m.m23;
            C3 = m.m21 * m.m32 - m.m31 * m.m22;
            C2 = m.m20 * m.m33 - m.m30 * m.m23;
            C1 = m.m20 * m.m32 - m.m30 * m.m22;
            C0 = m.m20 * m.m31 - m.m30 * m.m21;
        }

        internal float Determinant => S0 * C5 - S1 * C4 + S2 * C3 + S3 * C2 - S4 * C1 + S5 * C0;
    }
}
