using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class PoseSampleTests
    {
        [TestCase(double.NaN, 0, 0)]
        [TestCase(0, double.NaN, 0)]
        [TestCase(0, double.PositiveInfinity, 0)]
        [TestCase(0, 0, double.NaN)]
        public void PoseSample_NotFinite_Throws(double time, double x, double order) =>
            Assert.That(() => new PoseSample(time, new Vector3D(x, 0, 0), UnitQuaternion.Identity, order), Throws.ArgumentException);

        [Test]
        public void PoseSample_DefaultRotation_Throws() =>
            Assert.That(() => new PoseSample(0, default, default), Throws.ArgumentException);
    }
}
