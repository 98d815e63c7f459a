using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
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

        static readonly object[][] Invalid =
        {
            new object[] { double.NaN, 0, 0.1, SettingMessages.OutOfRange("marker 'cell 7': x of its offset", double.NaN, " m", -100, 100) },
            new object[] { 101, 0, 0.1, SettingMessages.OutOfRange("marker 'cell 7': x of its offset", 101, " m", -100, 100) },
            new object[] { 0, double.PositiveInfinity, 0.1, MarkerMessages.RotationInvalid("marker 'cell 7'") },
            new object[] { 0, 0, 0.001, SettingMessages.OutOfRange("marker 'cell 7': its size", 0.001, " m", 0.005, 5) },
            new object[] { 0, 0, -0.1, SettingMessages.OutOfRange("marker 'cell 7': its size", -0.1, " m", 0.005, 5) },
        };

        [TestCaseSource(nameof(Invalid))]
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

            Assert.That(fault.Message, Is.EqualTo(
                SettingMessages.OutOfRange("marker 'first second, and a lot…': its size", 9, " m", 0.005, 5)));
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
