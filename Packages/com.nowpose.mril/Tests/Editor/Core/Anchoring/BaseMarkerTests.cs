using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class BaseMarkerTests
    {
        static readonly RigidTransform Anywhere = RigidTransform.FromXyzRpy(0.3, -0.1, 0.02, 0.1, 0.2, -3);

        [Test]
        public void Constructor_ValidValues_StoresThem()
        {
            var marker = new BaseMarker("cell 7", Anywhere, 0.12);

            Assert.That(marker.Payload, Is.EqualTo("cell 7"));
            Assert.That(marker.MarkerInBase, Is.EqualTo(Anywhere));
            Assert.That(marker.SizeMetres, Is.EqualTo(0.12));
        }

        [TestCase(double.NaN, 0, 0.1, "marker 'cell 7': x of its offset: NaN m is out of range; allowed: -100 to 100 m")]
        [TestCase(101, 0, 0.1, "marker 'cell 7': x of its offset: 101 m is out of range; allowed: -100 to 100 m")]
        [TestCase(0, double.PositiveInfinity, 0.1, "marker 'cell 7': its rotation is invalid; enter three finite angles")]
        [TestCase(0, 0, 0.001, "marker 'cell 7': its size: 0.001 m is out of range; allowed: 0.005 to 5 m")]
        [TestCase(0, 0, -0.1, "marker 'cell 7': its size: -0.1 m is out of range; allowed: 0.005 to 5 m")]
        public void Constructor_NumberOutOfRange_NamesValueAndRange(double x, double yaw, double size, string message)
        {
            var fault = Assert.Throws<InputException>(
                () => new BaseMarker("cell 7", RigidTransform.FromXyzRpy(x, 0, 0, 0, 0, yaw), size));

            Assert.That(fault.Message, Is.EqualTo(message));
        }

        [Test]
        public void Constructor_EmptyOrTooLongPayload_Throws()
        {
            Assert.Throws<InputException>(() => new BaseMarker("", Anywhere));
            Assert.Throws<InputException>(() => new BaseMarker(null, Anywhere));
            Assert.Throws<InputException>(() => new BaseMarker(new string('x', 5000), Anywhere));
            Assert.Throws<InputException>(() => new BaseMarker("cell 7", default), "default is not a valid rotation");
        }

        [Test]
        public void Constructor_LongPayloadWithLineBreak_IsShortenedToOneLineInTheMessage()
        {
            var fault = Assert.Throws<InputException>(() => new BaseMarker("first\nsecond, and a lot more of it", Anywhere, 9));

            Assert.That(fault.Message, Does.StartWith("marker 'first second, and a lot…': its size: 9 m"));
        }

        [TestCase(0.0)]
        [TestCase(1e-9)]
        [TestCase(0.3)]
        [TestCase(3.1415926)]
        public void AngleTo_Rotated_ReturnsTheAngle(double angle)
        {
            var turned = Anywhere * RigidTransform.FromXyzRpy(1, 2, 3, 0, angle, 0);

            Assert.That(Anywhere.AngleTo(turned), Is.EqualTo(angle).Within(1e-12));
            Assert.That(Anywhere.DistanceTo(turned), Is.EqualTo(Math.Sqrt(14)).Within(1e-12));
        }
    }
}
