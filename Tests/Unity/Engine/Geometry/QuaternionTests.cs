using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Geometry;

/// <summary>
/// Tests Quaternion with reference values. A separate script computed them in double precision from rotation matrices, according to Unity's
/// documentation.
/// </summary>
public sealed class QuaternionTests
{
    const float Tolerance = 2e-6f;

    [TestCase(30, 40, 50, 0.3600422f, 0.1966282f, 0.3033718f, 0.8600422f)]
    [TestCase(-20, 100, 35, 0.1204016f, 0.7530547f, 0.317219f, 0.5637235f)]
    [TestCase(10, 0, 0, 0.0871557f, 0, 0, 0.9961947f)]
    [TestCase(89, 30, -60, 0.4940206f, 0.4983839f, -0.501578f, 0.5059413f)]
    [TestCase(300, 200, 100, 0.7091446f, 0.4817022f, 0.2013105f, -0.4738681f)]
    public void Euler_Degrees_RotatesAboutZThenXThenY(float x, float y, float z, float qx, float qy, float qz, float qw)
    {
        var q = Quaternion.Euler(x, y, z);

        AssertSame(q, new Quaternion(qx, qy, qz, qw));
    }

    // In a left-handed system, a positive angle is clockwise as seen from the tip of the axis.
    [TestCase(0, 90, 0, 0, 0, 1, 1, 0, 0)]
    [TestCase(90, 0, 0, 0, 0, 1, 0, -1, 0)]
    [TestCase(0, 0, 90, 1, 0, 0, 0, 1, 0)]
    [TestCase(30, 40, 50, 1, 2, 3, 1.648145f, 0.276755f, 3.34769f)]
    [TestCase(-20, 100, 35, 1, 2, 3, 2.088192f, 3.104548f, -0.035144f)]
    public void Multiply_Vector_RotatesTheVector(float x, float y, float z, float vx, float vy, float vz, float rx, float ry, float rz)
    {
        var turned = Quaternion.Euler(x, y, z) * new Vector3(vx, vy, vz);

        Assert.That(Vector3.Distance(turned, new Vector3(rx, ry, rz)), Is.LessThan(Tolerance));
    }

    [Test]
    public void Multiply_TwoQuaternions_AppliesTheRightQuaternionFirst()
    {
        var both = Quaternion.Euler(0, 90, 0) * Quaternion.Euler(0, 0, 90);

        Assert.That(Vector3.Distance(both * Vector3.right, Vector3.up), Is.LessThan(Tolerance));
        Assert.That(Vector3.Distance(both * Vector3.up, Vector3.forward), Is.LessThan(Tolerance));
    }

    [TestCase(30, 40, 50)]
    [TestCase(340, 100, 35)]
    [TestCase(0, 0, 0)]
    [TestCase(0, 359, 1)]
    [TestCase(89, 30, 300)]
    public void EulerAngles_OfAnEulerRotation_RoundTrip(float x, float y, float z)
    {
        var angles = Quaternion.Euler(x, y, z).eulerAngles;

        // The tolerance is large because the angles have few significant digits near the poles.
        Assert.That(Mathf.DeltaAngle(angles.x, x), Is.EqualTo(0).Within(0.05f));
        Assert.That(Mathf.DeltaAngle(angles.y, y), Is.EqualTo(0).Within(0.05f));
        Assert.That(Mathf.DeltaAngle(angles.z, z), Is.EqualTo(0).Within(0.05f));
        Assert.That(angles.x, Is.InRange(0, 360));
    }

    [TestCase(90, 70, 20)]
    [TestCase(-90, 70, 20)]
    public void EulerAngles_StraightUpOrDown_GiveTheSameRotation(float x, float y, float z)
    {
        var q = Quaternion.Euler(x, y, z);

        AssertSame(Quaternion.Euler(q.eulerAngles), q, 1e-3f);
    }

    [Test]
    public void AngleAxis_LongAxis_RotatesAboutItsDirection()
    {
        var q = Quaternion.AngleAxis(70, new Vector3(1, 2, 3));

        AssertSame(q, new Quaternion(0.1532948f, 0.3065895f, 0.4598843f, 0.819152f));
        Assert.That(Vector3.Distance(q * Vector3.right, new Vector3(0.389019f, 0.847427f, -0.361291f)), Is.LessThan(Tolerance));
    }

    [Test]
    public void AngleAxis_ZeroAxis_IsTheIdentity() => Assert.That(Quaternion.AngleAxis(70, Vector3.zero), Is.EqualTo(Quaternion.identity));

    [Test]
    public void LookRotation_ForwardAndUp_AlignsForwardExactlyAndUpApproximately()
    {
        var q = Quaternion.LookRotation(new Vector3(1, 2, -2), new Vector3(0.3f, 1, 0.2f));

        AssertSame(q, new Quaternion(0.1149686f, 0.9056023f, 0.3852346f, 0.135133f));
        Assert.That(Vector3.Distance(q * Vector3.forward, new Vector3(1, 2, -2) / 3), Is.LessThan(Tolerance));
        Assert.That(Vector3.Distance(q * Vector3.right, new Vector3(-0.9370426f, 0.3123475f, -0.1561738f)), Is.LessThan(Tolerance));
    }

    // The cases cover the four branches of the conversion to a quaternion; each component is the largest in one case.
    [TestCase(10, 20, 30)]
    [TestCase(170, 5, 10)]
    [TestCase(5, 170, 10)]
    [TestCase(5, 10, 170)]
    public void LookRotation_AxesOfARotation_ReturnsThatRotation(float x, float y, float z)
    {
        var q = Quaternion.Euler(x, y, z);

        AssertSame(Quaternion.LookRotation(q * Vector3.forward, q * Vector3.up), q);
    }

    [TestCase(0, 5, 0)]
    [TestCase(0, -1, 0)]
    public void LookRotation_ForwardParallelToUp_LooksAlongForward(float x, float y, float z)
    {
        var way = new Vector3(x, y, z);

        Assert.That(Vector3.Distance(Quaternion.LookRotation(way) * Vector3.forward, way.normalized), Is.LessThan(Tolerance));
    }

    [Test]
    public void LookRotation_ZeroVector_IsTheIdentity() => Assert.That(Quaternion.LookRotation(Vector3.zero), Is.EqualTo(Quaternion.identity));

    [TestCase(1, 0, 0, 0, 1, 0, 0, 0, 0.7071068f, 0.7071068f)]
    [TestCase(0, 0, 2, 3, 0, 0, 0, 0.7071068f, 0, 0.7071068f)]
    public void FromToRotation_TwoVectors_IsTheShortestRotation(float fx, float fy, float fz, float tx, float ty, float tz, float x, float y, float z, float w)
    {
        var q = Quaternion.FromToRotation(new Vector3(fx, fy, fz), new Vector3(tx, ty, tz));

        AssertSame(q, new Quaternion(x, y, z, w));
    }

    [Test]
    public void FromToRotation_Opposite_IsHalfATurn()
    {
        var from = new Vector3(1, 2, 3);

        var q = Quaternion.FromToRotation(from, -from);

        Assert.That(Vector3.Distance(q * from, -from), Is.LessThan(1e-5f));
        Assert.That(Quaternion.Angle(q, Quaternion.identity), Is.EqualTo(180).Within(1e-3));
    }

    [Test]
    public void Angle_BothSignsOfOneRotation_IsZero()
    {
        var q = Quaternion.Euler(30, 40, 50);

        Assert.That(Quaternion.Angle(q, new Quaternion(-q.x, -q.y, -q.z, -q.w)), Is.Zero);
        Assert.That(Quaternion.Angle(Quaternion.identity, Quaternion.Euler(0, 90, 0)), Is.EqualTo(90).Within(1e-3));
    }

    [Test]
    public void Inverse_TimesTheRotation_IsTheIdentity()
    {
        var q = Quaternion.Euler(30, 40, 50);

        Assert.That(Vector3.Distance(Quaternion.Inverse(q) * new Vector3(1.648145f, 0.276755f, 3.34769f), new Vector3(1, 2, 3)), Is.LessThan(4e-6f));
    }

    [Test]
    public void Normalize_Zero_IsTheIdentity() => Assert.That(Quaternion.Normalize(default), Is.EqualTo(Quaternion.identity));

    static void AssertSame(Quaternion actual, Quaternion expected, float tolerance = Tolerance)
    {
        // A quaternion and its negative represent the same rotation.
        var sign = Quaternion.Dot(actual, expected) < 0 ? -1 : 1;
        float[] signed = [actual.x * sign, actual.y * sign, actual.z * sign, actual.w * sign];
        float[] wanted = [expected.x, expected.y, expected.z, expected.w];
        Assert.That(signed, Is.EqualTo(wanted).Within(tolerance), $"{actual:F6} is not {expected:F6}");
    }
}
