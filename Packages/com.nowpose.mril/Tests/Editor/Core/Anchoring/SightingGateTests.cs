using System;
using Nowpose.Anchoring;
using Nowpose.Anchoring.Tracking;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class SightingGateTests
    {
        const double Degree = Math.PI / 180;

        static readonly HeadsetTime Now = HeadsetTime.FromSeconds(50);

        // The marker lies face up, half a metre ahead of the head and one metre below it. It is seen at 26.6° from its normal.
        static readonly RigidTransform Head = RigidTransform.FromXyzRpy(0, 0, 2, 0, 60 * Degree, 0);
        static readonly RigidTransform Pose = RigidTransform.FromXyzRpy(0.5, 0, 1, 0, 0, 1);

        static SightingFault Judge(
            RigidTransform? pose = null, double size = 0.1, double age = 0.1, MarkerTracking tracking = MarkerTracking.Tracking,
            RigidTransform? head = null, double printed = 0.1) => SightingGate.Judge(
            new MarkerSighting("1", "a", pose ?? Pose, size, HeadsetTime.FromSeconds(50 - age), tracking),
            new BaseMarker("a", RigidTransform.Identity, printed), Now, head ?? Head, new AnchoringSettings());

        [Test]
        public void Judge_CurrentSightingAtAShortDistance_IsAccepted()
        {
            Assert.That(Judge(), Is.EqualTo(SightingFault.None));
            Assert.That(Judge(size: 0), Is.EqualTo(SightingFault.None), "the device does not report a size");
            Assert.That(Judge(printed: 0), Is.EqualTo(SightingFault.None), "the cell does not state a size");
            Assert.That(Judge(size: 0.105), Is.EqualTo(SightingFault.None));
            Assert.That(Judge(age: -0.01), Is.EqualTo(SightingFault.None), "slightly in the future");
        }

        [Test]
        public void Judge_InvalidSighting_ReturnsTheFault()
        {
            Assert.That(Judge(tracking: MarkerTracking.None), Is.EqualTo(SightingFault.NotTracked));
            Assert.That(Judge(tracking: MarkerTracking.Limited), Is.EqualTo(SightingFault.NotTracked));
            Assert.That(Judge(pose: default(RigidTransform)), Is.EqualTo(SightingFault.NoPose));
            Assert.That(Judge(pose: RigidTransform.Identity), Is.EqualTo(SightingFault.AtOrigin));
            Assert.That(Judge(age: 2.1), Is.EqualTo(SightingFault.Old));
            Assert.That(Judge(age: -1), Is.EqualTo(SightingFault.Old), "in the future");
            Assert.That(Judge(size: 0.12), Is.EqualTo(SightingFault.OtherSize));
            Assert.That(Judge(size: 0.08), Is.EqualTo(SightingFault.OtherSize));
        }

        [Test]
        public void Judge_UnsuitableHeadPosition_ReturnsTheFault()
        {
            Assert.That(Judge(head: RigidTransform.FromXyzRpy(0.5, 0, 3.6, 0, 90 * Degree, 0)), Is.EqualTo(SightingFault.TooFar));
            Assert.That(Judge(head: RigidTransform.FromXyzRpy(-0.6, 0, 1.5, 0, 0, 0)), Is.EqualTo(SightingFault.TooOblique));
            Assert.That(Judge(head: RigidTransform.FromXyzRpy(0.3, 0, 0, 0, -90 * Degree, 0)), Is.EqualTo(SightingFault.TooOblique), "the head is below the marker");
            Assert.That(Judge(head: RigidTransform.FromXyzRpy(1, 0, 2, 0, -20 * Degree, 0)), Is.EqualTo(SightingFault.Behind));
        }

        [Test]
        public void Judge_PlacedByHand_IsAcceptedFromAnywhere()
        {
            var placed = MarkerTracking.Placed;

            Assert.That(Judge(tracking: placed, age: 1000), Is.EqualTo(SightingFault.None));
            Assert.That(Judge(tracking: placed, head: RigidTransform.FromXyzRpy(50, 0, 0, 0, 0, 0)), Is.EqualTo(SightingFault.None));
            Assert.That(Judge(tracking: placed, pose: default(RigidTransform)), Is.EqualTo(SightingFault.NoPose));
        }

        static readonly object[][] Invalid =
        {
            new object[] { SettingMessages.OutOfRange("settle", 0, " ms", 100, 60000), 0, 400, 2.5, 60, 10 },
            new object[] { SettingMessages.OutOfRange("maximum age", double.NaN, " ms", 20, 10000), 1850, double.NaN, 2.5, 60, 10 },
            new object[] { SettingMessages.OutOfRange("maximum distance", -1, " m", 0.1, 20), 1850, 400, -1, 60, 10 },
            new object[] { SettingMessages.OutOfRange("maximum viewing angle", 90, " °", 10, 89), 1850, 400, 2.5, 90, 10 },
            new object[] { SettingMessages.OutOfRange("tolerance", 2, " m", 0.001, 1), 1850, 400, 2.5, 60, 2000 },
        };

        [TestCaseSource(nameof(Invalid))]
        public void Settings_OutOfRange_NameValueAndRange(
            string message, double settle, double oldest, double farthest, double oblique, double toleranceMm)
        {
            var fault = Assert.Throws<InputException>(() => new AnchoringSettings(
                settle, oldest, farthest, oblique, toleranceMetres: toleranceMm / 1000));

            Assert.That(fault.Message, Is.EqualTo(message));
        }
    }
}
