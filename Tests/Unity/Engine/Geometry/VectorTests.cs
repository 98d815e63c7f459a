using System.Globalization;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Geometry;

public sealed class VectorTests
{
    [Test]
    public void Cross_RightAndUp_IsForward() => Assert.That(Vector3.Cross(Vector3.right, Vector3.up), Is.EqualTo(Vector3.forward));

    [TestCase(0.9e-5f, true)]
    [TestCase(1.1e-5f, false)]
    public void Equals_SmallDifference_IsTolerated(float difference, bool same)
    {
        Assert.That(new Vector3(0, difference, 0) == Vector3.zero, Is.EqualTo(same));
        Assert.That(new Vector3(0, difference, 0).Equals(Vector3.zero), Is.False);
    }

    [Test]
    public void Normalized_TooShort_IsZero()
    {
        Assert.That(new Vector3(0, 0.9e-5f, 0).normalized, Is.EqualTo(Vector3.zero));
        Assert.That(new Vector3(3, 0, 4).normalized, Is.EqualTo(new Vector3(0.6f, 0, 0.8f)));
    }

    [Test]
    public void ToString_AnyCulture_HasTwoDigitsAfterAPoint() =>
        Assert.That(new Vector3(1.234f, -2, 3).ToString(), Is.EqualTo("(1.23, -2.00, 3.00)"));

    [Test]
    public void ToString_Format_AppliesToEachNumber() =>
        Assert.That(new Vector3(1.234f, -2, 3).ToString("F1", CultureInfo.InvariantCulture), Is.EqualTo("(1.2, -2.0, 3.0)"));

    [TestCase(350, 10, 20)]
    [TestCase(10, 350, -20)]
    [TestCase(0, 180, 180)]
    public void DeltaAngle_AnyAngles_IsTheShortestDifference(float from, float to, float expected) =>
        Assert.That(Mathf.DeltaAngle(from, to), Is.EqualTo(expected).Within(1e-4));
}
