using System;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;
using static Nowpose.Tests.Core.Anchoring.LockedMarkers;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests locks by several markers, and the report of markers that contradict each other.</summary>
    public class SeveralMarkersTests
    {
        [Test]
        public void Tick_ContradictingMarkerRemoved_LocksWithTheOtherMarker()
        {
            var cell = new SimulatedMarkers(1);
            cell.Use(("a", RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0)), ("b", RigidTransform.FromXyzRpy(-0.2, 0, 0, 0, 0, 0)));
            cell.Noisy();
            cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.24, 0, 0, 0, 0, 0);
            cell.Run(4);
            Assert.That(cell.Tracker.Conflict, Is.Not.Null);

            cell.IsInView = payload => payload == "a";

            Assert.That(cell.RunUntilLocked(16), Is.Not.Null);
            Assert.That(cell.Tracker.Conflict, Is.Null);
        }

        [Test]
        public void Lock_NoisyMarkers_ReportsTheScatterOfTheirPoses([Values] bool isThree)
        {
            var cell = isThree ? SimulatedMarkers.Three(1) : SimulatedMarkers.One(1, 0);
            cell.Noisy();

            Locked(cell);

            Assert.That(cell.Tracker.Lock.SpreadMetres, Is.EqualTo(cell.NoiseMetres).Within(25).Percent);
            Assert.That(cell.Tracker.Lock.SpreadRadians, Is.EqualTo(cell.NoiseDegrees * Math.PI / 180).Within(25).Percent);
        }

        [Test]
        public void Tick_TwoMarkersDisagree_DoesNotLockAndNamesBothMarkers()
        {
            var cell = new SimulatedMarkers(1);
            cell.Use(("a", RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0)), ("b", RigidTransform.FromXyzRpy(-0.2, 0, 0, 0, 0, 0)));
            cell.Noisy();
            cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.24, 0, 0, 0, 0, 0);

            Assert.That(cell.RunUntilLocked(5), Is.Null);

            Assert.That(cell.Tracker.Conflict.Marker.Payload, Is.EqualTo("a"));
            Assert.That(cell.Tracker.Conflict.Other.Payload, Is.EqualTo("b"));
            Assert.That(cell.Tracker.Conflict.Metres, Is.EqualTo(0.04).Within(0.003));
        }

        [TestCase(0.04, 0, 0)]
        [TestCase(0, 0, 0.03)]
        [TestCase(0, 0.1, 0)]
        public void Tick_OneOfThreeMarkersMisplaced_LocksWithTheOthersAndNamesTheMarker(double x, double y, double z)
        {
            for (var seed = 1; seed <= 10; seed++)
            {
                var cell = SimulatedMarkers.Three(seed);
                cell.Noisy();
                cell.Shifted["c"] = RigidTransform.FromXyzRpy(-0.0866 + x, -0.15 + y, z, 0, 0, -1);

                Locked(cell);

                Assert.That(cell.Tracker.Conflict.Marker.Payload, Is.EqualTo("c"), "seed " + seed);
                Assert.That(cell.Tracker.Conflict.Other, Is.Null);
                Assert.That(cell.Tracker.Conflict.Metres, Is.EqualTo(Math.Sqrt(x * x + y * y + z * z)).Within(0.005), "seed " + seed);
                Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(2));
                Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.002), "seed " + seed);
                cell.Run(3);
                Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked),
                    "a marker that is known to be misplaced is not reported as moved");
            }
        }

        // Three positions always determine a plane, so that such an error leaves no misfit. The angles of all prints then contradict the plane, which
        // does not show whether one position or all angles are wrong.
        [TestCase(0, 0.006)]
        [TestCase(0, 0.008)]
        [TestCase(0.012, 0)]
        public void Tick_OffsetErrorThatTurnsTheBase_IsReported(double y, double z)
        {
            for (var seed = 1; seed <= 10; seed++)
            {
                var cell = SimulatedMarkers.Three(seed);
                cell.Noisy();
                cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.1732, y, z, 0, 0, 0.4);

                cell.Run(4);

                Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching), "seed " + seed);
                Assert.That(cell.Tracker.Conflict?.Radians, Is.GreaterThan(0.02), "seed " + seed);
                Assert.That(cell.Tracker.Markers.Any(marker => marker.IsContradicted), Is.False, "seed " + seed);
            }
        }

        // A larger error exceeds the tolerance of a single print. Only the other two markers then agree.
        [Test]
        public void Tick_LargeOffsetErrorThatTurnsTheBase_LocksWithTheOthersAndNamesTheMarker()
        {
            for (var seed = 1; seed <= 10; seed++)
            {
                var cell = SimulatedMarkers.Three(seed);
                cell.Noisy();
                cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.1732, 0, 0.012, 0, 0, 0.4);

                cell.Run(4);

                Assert.That(cell.Tracker.Conflict?.Marker.Payload, Is.EqualTo("a"), "seed " + seed);
                Assert.That(cell.Tracker.Conflict.Metres, Is.EqualTo(0.012).Within(0.002), "seed " + seed);
                Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(2), "seed " + seed);
                Assert.That(cell.ErrorAt(0.6).Metres, Is.LessThan(0.004), "seed " + seed);
            }
        }

        // A device may measure the angles of all prints wrongly in the same way, for example because it sees all of them from one side.
        [Category("Study")]
        [TestCase(3, 1.0, true)]
        [TestCase(3, 1.4, false)]
        [TestCase(3, 1.7, false)]
        [TestCase(6, 1.0, true)]
        [TestCase(6, 1.4, false)]
        [TestCase(6, 1.7, false)]
        public void Tick_CommonErrorOfAllAngles_ExcludesNoMarker(int count, double degrees, bool isLocked)
        {
            for (var seed = 1; seed <= 20; seed++)
            {
                var cell = SimulatedMarkers.Ring(count, seed);
                (cell.NoiseMetres, cell.NoiseDegrees) = (0.002, 0.5);
                cell.CommonTurn = PoseNumbers.Turn(degrees * Math.PI / 180, 0, 0);

                cell.Run(4);

                Assert.That(cell.Tracker.Markers.Any(marker => marker.IsContradicted), Is.False, "seed " + seed);
                Assert.That(cell.Tracker.Lock?.Markers, Is.EqualTo(isLocked ? count : (int?)null), "seed " + seed);
                Assert.That(cell.Tracker.Conflict == null, Is.EqualTo(isLocked), "seed " + seed);
                if (isLocked) Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.002), "seed " + seed);
            }
        }

        // Angle errors of glued prints, which are independent of each other, are not a contradiction.
        [Category("Study")]
        [Test]
        public void Tick_PrintsTiltedByHalfADegreePerAxis_AgreeWithThePositions()
        {
            var conflicts = 0;
            for (var seed = 1; seed <= 200; seed++)
            {
                var cell = SimulatedMarkers.Three(seed);
                cell.Noisy();
                cell.PrintDegrees = 0.5 * Math.Sqrt(3);

                cell.RunUntilLocked(4);

                if (cell.Tracker.Conflict != null) conflicts++;
            }
            Assert.That(conflicts, Is.LessThanOrEqualTo(3));
        }

        [Test]
        public void Tick_MoreMarkersInView_ImprovesTheLock()
        {
            var cell = SimulatedMarkers.Three(5);
            cell.Noisy();
            cell.PrintDegrees = 0.5;
            cell.IsInView = payload => payload == "a";
            Locked(cell);
            Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(1));

            cell.IsInView = payload => payload != "a";
            cell.Run(4);

            Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(3));
            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.InRange(1e-6, 0.01), "the change is reported");
        }

        // A gap removes the sightings of a marker, and the next sighting alone gives no new estimate.
        [Test]
        public void Tick_NewMarkerAfterAPartWasSeenOnceInAGap_ImprovesTheLock()
        {
            var cell = NoisyOneOfThree();
            var spread = cell.Tracker.Lock.SpreadMetres;
            cell.IsInView = _ => false;
            cell.Run(5);
            cell.IsInView = payload => payload == "a";
            cell.Run(2 / 60.0);
            Assert.That(cell.Tracker.Markers[0].SpreadMetres, Is.Null);

            cell.IsInView = payload => payload == "b";
            cell.Run(4);

            AssertBothAreParts(cell);
            Assert.That(cell.Tracker.Lock.SpreadMetres, Is.EqualTo(spread).Within(0.0005), "both markers have the same noise");
        }

        [Test]
        public void Tick_NewMarkerAfterThePositionWasLost_ImprovesTheLock()
        {
            var cell = NoisyOneOfThree(new FakeAnchors());
            cell.Anchors.Held[0].State = SpatialAnchorState.Lost;
            cell.Run(1);
            cell.Anchors.Held[0].State = SpatialAnchorState.Tracking;

            cell.IsInView = payload => payload == "b";
            cell.Run(4);

            AssertBothAreParts(cell);
        }

        [Test]
        public void Tick_SecondMarkerAtAWrongPlace_IsDetected()
        {
            var cell = SimulatedMarkers.Three(6);
            cell.Noisy();
            cell.IsInView = payload => payload == "a";
            Locked(cell);
            cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866, 0.19, 0, 0, 0, 2);

            cell.IsInView = payload => payload == "b";
            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(cell.Tracker.Markers[1].DeviationMetres, Is.EqualTo(0.04).Within(0.006));
        }

        [Test]
        public void Tick_SameCodeInTwoPlaces_IgnoresBothSightings()
        {
            var cell = SimulatedMarkers.One(1, 0);
            var other = false;
            cell.Change = sighting => (other = !other)
                ? sighting
                : new MarkerSighting("2", "a", sighting.Pose * RigidTransform.FromXyzRpy(1, 0, 0, 0, 0, 0), 0, cell.Now, MarkerTracking.Tracking);

            Assert.That(cell.RunUntilLocked(6), Is.Null);
            Assert.That(cell.Tracker.Markers[0].Ignored[SightingFault.TwoPlaces], Is.GreaterThan(50));
        }

        /// <summary>Creates a base with three markers that is locked by marker a.</summary>
        static SimulatedMarkers NoisyOneOfThree(FakeAnchors anchors = null)
        {
            var cell = SimulatedMarkers.Three(5);
            cell.Anchors = anchors;
            cell.Noisy();
            cell.IsInView = payload => payload == "a";
            Locked(cell);
            Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(1));
            return cell;
        }

        static void AssertBothAreParts(SimulatedMarkers cell)
        {
            Assert.That((cell.Tracker.State, cell.Tracker.Lock.Markers), Is.EqualTo((BaseAnchorState.Locked, 2)));
            Assert.That(cell.Tracker.Base.Value.DistanceTo(cell.Tracker.Lock.Base), Is.EqualTo(0));
            Assert.That(cell.Tracker.Markers[1].DeviationMetres, Is.LessThan(0.003));
        }
    }
}
