using System.Globalization;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Headless.Tests.Engine.Geometry;

public sealed class VectorTests
{
    [Test]
    public void Cross_RightAndUp_IsForward() => Assert.That(Vector3.Cross(Vector3.right, Vector3.up), Is.EqualTo(Vector3.forward));

    [TestCase(0.9e-5f, true)]
    [TestCase(1.1e-5f, false)]
    public void Equality_IsWithinAHundredThousandth(float difference, bool same)
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
    public void SignedAngle_ClockwiseSeenFromTheAxis_IsPositive()
    {
        Assert.That(Vector3.SignedAngle(Vector3.forward, Vector3.right, Vector3.up), Is.EqualTo(90).Within(1e-4));
        Assert.That(Vector3.SignedAngle(Vector3.right, Vector3.forward, Vector3.up), Is.EqualTo(-90).Within(1e-4));
    }

    [TestCase(1, 1, 0, 0)]
    [TestCase(9, 3, 4, 0)]
    [TestCase(-5, -3, -4, 0)]
    public void MoveTowards_GoesNoFurtherThanTheTarget(float step, float x, float y, float z)
    {
        var target = new Vector3(3, 4, 0);
        var moved = Vector3.MoveTowards(Vector3.zero, target, step);

        var expected = step == 1 ? new Vector3(0.6f, 0.8f, 0) : new Vector3(x, y, z);
        Assert.That(Vector3.Distance(moved, expected), Is.LessThan(1e-6f));
    }

    [Test]
    public void ProjectOnPlane_LeavesNothingAlongTheNormal() =>
        Assert.That(Vector3.ProjectOnPlane(new Vector3(1, 2, 3), new Vector3(0, 5, 0)), Is.EqualTo(new Vector3(1, 0, 3)));

    [Test]
    public void ToString_AnyCulture_HasTwoDigitsAfterAPoint() =>
        Assert.That(new Vector3(1.234f, -2, 3).ToString(), Is.EqualTo("(1.23, -2.00, 3.00)"));

    [Test]
    public void ToString_Format_IsOfEachNumber() =>
        Assert.That(new Vector3(1.234f, -2, 3).ToString("F1", CultureInfo.InvariantCulture), Is.EqualTo("(1.2, -2.0, 3.0)"));

    [Test]
    public void SmoothDamp_ManySteps_ArrivesWithoutOvershoot()
    {
        var velocity = Vector3.zero;
        var position = Vector3.zero;
        for (var i = 0; i < 200; i++)
        {
            position = Vector3.SmoothDamp(position, Vector3.right, ref velocity, 0.2f, float.PositiveInfinity, 0.01f);
            Assert.That(position.x, Is.LessThanOrEqualTo(1 + 1e-5f));
        }

        Assert.That(position.x, Is.EqualTo(1).Within(1e-3));
    }

    [TestCase(350, 10, 20)]
    [TestCase(10, 350, -20)]
    [TestCase(0, 180, 180)]
    public void DeltaAngle_IsTheShortWay(float from, float to, float expected) =>
        Assert.That(Mathf.DeltaAngle(from, to), Is.EqualTo(expected).Within(1e-4));
}
