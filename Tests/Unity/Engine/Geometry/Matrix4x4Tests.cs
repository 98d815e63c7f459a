using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Geometry;

public sealed class Matrix4x4Tests
{
    static readonly Matrix4x4 Placed = Matrix4x4.TRS(new Vector3(1, -2, 4), Quaternion.Euler(30, 40, 50), new Vector3(2, 3, 0.5f));

    // The expected point was computed in double precision in the documented order: scale, rotate, translate.
    [Test]
    public void Trs_Point_ScalesThenRotatesThenTranslates() => Assert.That(
        Vector3.Distance(Placed.MultiplyPoint3x4(new Vector3(0.5f, 0.25f, -1)), new Vector3(1.175094f, -0.669083f, 4.102484f)),
        Is.LessThan(2e-6f));

    [Test]
    public void MultiplyVector_Translation_IsIgnored() => Assert.That(
        Vector3.Distance(Placed.MultiplyVector(new Vector3(0.5f, 0.25f, -1)), new Vector3(0.175094f, 1.330917f, 0.102484f)),
        Is.LessThan(2e-6f));

    [Test]
    public void Multiply_TwoMatrices_AppliesTheRightMatrixFirst()
    {
        var move = Matrix4x4.TRS(Vector3.right, Quaternion.identity, Vector3.one);
        var turn = Matrix4x4.Rotate(Quaternion.Euler(0, 90, 0));

        Assert.That(Vector3.Distance((turn * move).MultiplyPoint3x4(Vector3.zero), Vector3.back), Is.LessThan(1e-6f));
        Assert.That((move * turn).MultiplyPoint3x4(Vector3.zero), Is.EqualTo(Vector3.right));
    }

    [Test]
    public void RowsAndColumns_TranslationMatrix_FollowTheMathematicalConvention()
    {
        var matrix = Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.identity, Vector3.one);

        Assert.That(matrix.m13, Is.EqualTo(2));
        Assert.That(matrix.GetRow(1), Is.EqualTo(new Vector4(0, 1, 0, 2)));
        Assert.That(matrix.GetColumn(3), Is.EqualTo(new Vector4(1, 2, 3, 1)));
    }
}
