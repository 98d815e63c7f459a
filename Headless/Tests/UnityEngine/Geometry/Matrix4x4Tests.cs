using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Engine.Geometry;

public sealed class Matrix4x4Tests
{
    static readonly Matrix4x4 Placed = Matrix4x4.TRS(new Vector3(1, -2, 4), Quaternion.Euler(30, 40, 50), new Vector3(2, 3, 0.5f));

    // Worked out in double precision from the documented order: scale, turn, move.
    [Test]
    public void Trs_ScalesThenTurnsThenMoves() =>
        Assert.That(Vector3.Distance(Placed.MultiplyPoint3x4(new Vector3(0.5f, 0.25f, -1)), new Vector3(1.175094f, -0.669083f, 4.102484f)),
            Is.LessThan(2e-6f));

    [Test]
    public void MultiplyVector_DoesNotMove() =>
        Assert.That(Matrix4x4.Translate(Vector3.one).MultiplyVector(Vector3.up), Is.EqualTo(Vector3.up));

    [Test]
    public void Indexer_CountsDownTheColumns()
    {
        var matrix = Matrix4x4.Translate(new Vector3(1, 2, 3));

        Assert.That((matrix[12], matrix[0, 3], matrix.m03), Is.EqualTo((1f, 1f, 1f)));
        Assert.That(matrix.GetRow(1), Is.EqualTo(new Vector4(0, 1, 0, 2)));
        Assert.That(matrix.GetColumn(3), Is.EqualTo(new Vector4(1, 2, 3, 1)));
    }

    [Test]
    public void Inverse_TimesItself_IsIdentity()
    {
        var product = Placed * Placed.inverse;

        for (var i = 0; i < 16; i++) Assert.That(product[i], Is.EqualTo(Matrix4x4.identity[i]).Within(2e-6), $"element {i}");
    }

    [Test]
    public void Inverse_OfAPerspective_IsIts()
    {
        var m = new Matrix4x4(new Vector4(2, 0, 1, 0), new Vector4(0, 3, 0, 1), new Vector4(1, 0, -1, -1), new Vector4(0, 2, -0.5f, 0));
        var product = m.inverse * m;

        for (var i = 0; i < 16; i++) Assert.That(product[i], Is.EqualTo(Matrix4x4.identity[i]).Within(2e-6), $"element {i}");
    }

    [Test]
    public void Inverse_OfAFlatMatrix_IsZero() => Assert.That(Matrix4x4.Scale(new Vector3(1, 0, 1)).inverse, Is.EqualTo(Matrix4x4.zero));

    [Test]
    public void Determinant_IsTheVolume() => Assert.That(Placed.determinant, Is.EqualTo(3).Within(1e-5));

    [Test]
    public void Parts_OfTrs_AreThoseItWasMadeOf()
    {
        Assert.That(Placed.GetPosition(), Is.EqualTo(new Vector3(1, -2, 4)));
        Assert.That(Vector3.Distance(Placed.lossyScale, new Vector3(2, 3, 0.5f)), Is.LessThan(1e-6f));
        Assert.That(Quaternion.Angle(Placed.rotation, Quaternion.Euler(30, 40, 50)), Is.LessThan(1e-3f));
    }

    [TestCase(170, 0, 0)]
    [TestCase(0, 170, 0)]
    [TestCase(0, 0, 170)]
    [TestCase(10, 20, 30)]
    public void Rotation_NearHalfATurn_IsExact(float x, float y, float z)
    {
        var q = Quaternion.Euler(x, y, z);

        Assert.That(Mathf.Abs(Quaternion.Dot(Matrix4x4.Rotate(q).rotation, q)), Is.EqualTo(1).Within(1e-6));
    }
}
