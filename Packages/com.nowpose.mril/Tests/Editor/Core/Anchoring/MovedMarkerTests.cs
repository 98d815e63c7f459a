using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;
using static Nowpose.Tests.Core.Anchoring.LockedMarkers;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Checks that a locked base reports a moved marker without following it, and that it ignores invalid sightings.</summary>
    public class MovedMarkerTests
    {
        const double Degree = Math.PI / 180;

        [Test]
        public void Tick_StalePoseMarkedAsTracked_DoesNotMoveALockedBase()
        {
            var cell = NoisyOne();
            var before = cell.Tracker.Base.Value;
            var last = cell.Now;
            cell.Change = sighting => new MarkerSighting(
                "1", "a", RigidTransform.FromXyzRpy(0.5, 0, 0, 0, 0, 0) * sighting.Pose, 0, last, MarkerTracking.Tracking);

            cell.Run(5);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
            Assert.That(cell.Tracker.Markers[0].Fault, Is.EqualTo(SightingFault.Old));
            Assert.That(cell.Tracker.Markers[0].Ignored[SightingFault.Old], Is.EqualTo(1), "one old sighting, reported 300 times");
        }

        [Test]
        public void Tick_PoseAtTheOriginOrInvalid_DoesNotMoveALockedBase()
        {
            var poses = new[]
            {
                RigidTransform.Identity, default, RigidTransform.FromXyzRpy(double.NaN, 0, 0, 0, 0, 0),
                RigidTransform.FromXyzRpy(0, 0, 0, 0, 0, double.PositiveInfinity),
            };
            foreach (var pose in poses)
            {
                var cell = NoisyOne();
                var before = cell.Tracker.Base.Value;
                cell.Change = sighting => new MarkerSighting("1", "a", pose, 0, sighting.LastSeen, MarkerTracking.Tracking);

                cell.Run(3);

                Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
                Assert.That(cell.Tracker.Base.Value.DistanceTo(before), Is.EqualTo(0));
                Assert.That(
                    cell.Tracker.Markers[0].Ignored[SightingFault.AtOrigin] + cell.Tracker.Markers[0].Ignored[SightingFault.NoPose],
                    Is.GreaterThan(80));
            }
        }

        [TestCase(0.008, 0, 0.008, 0)]
        [TestCase(0.01, 0, 0.01, 0)]
        [TestCase(0.02, 0, 0.02, 0)]
        [TestCase(0, 1, 0, 1)]
        [TestCase(0, 3, 0, 3)]
        [TestCase(0.3, 20, 0.3, 20)]
        public void Tick_MarkerMoved_IsDetectedWithinASecondAndNotFollowed(
            double metres, double degrees, double reportedMetres, double reportedDegrees)
        {
            for (var seed = 1; seed <= 20; seed++)
            {
                var cell = NoisyOne(seed);
                var before = cell.Tracker.Base.Value;
                cell.Shifted["a"] =
                    RigidTransform.FromXyzRpy(0.3, 0, 0, 0, 0, 0.4) * RigidTransform.FromXyzRpy(metres, 0, 0, 0, degrees * Degree, 0);

                cell.Run(1);

                var marker = cell.Tracker.Markers[0];
                Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved), "seed " + seed);
                Assert.That(marker.HasMoved, Is.True);
                Assert.That(marker.DeviationMetres, Is.EqualTo(reportedMetres).Within(0.0025), "seed " + seed);
                Assert.That(marker.DeviationRadians / Degree, Is.EqualTo(reportedDegrees).Within(0.6), "seed " + seed);
                Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), "the base does not follow");
            }
        }

        [Category("Study")]
        [Test]
        public void Tick_MarkerAtRest_IsNeverReportedAsMoved()
        {
            for (var seed = 1; seed <= 4; seed++)
            {
                var cell = NoisyOne(seed);

                cell.Run(60, () => Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked), "seed " + seed));
            }
        }

        [Test]
        public void Tick_MarkerDriftsSlowly_IsDetectedNearTheTolerance()
        {
            var cell = NoisyOne();
            var start = cell.Seconds;
            var place = RigidTransform.FromXyzRpy(0.3, 0, 0, 0, 0, 0.4);
            while (cell.Tracker.State == BaseAnchorState.Locked && cell.Seconds - start < 60)
            {
                cell.Shifted["a"] = place * RigidTransform.FromXyzRpy(0.001 * (cell.Seconds - start), 0, 0, 0, 0, 0);
                cell.Frame();
            }

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(cell.Seconds - start, Is.InRange(4.5, 7), "the marker moves 1 mm per second; the tolerance is 5 mm");
        }

        [Test]
        public void Use_MovedMarkerRemoved_BaseIsLockedAgain()
        {
            var cell = Locked(SimulatedMarkers.Three(1));
            cell.IsInView = payload => payload == "a";
            cell.Run(1);
            var markers = new[] { cell.Tracker.Markers[0].Marker, cell.Tracker.Markers[1].Marker, cell.Tracker.Markers[2].Marker };
            // Marker d was not used for the lock.
            cell.Tracker.Use("cell", new[] { markers[0], markers[1], markers[2], new BaseMarker("d", RigidTransform.Identity) });
            var sightings = new[]
            {
                new MarkerSighting("d", "d", RigidTransform.FromXyzRpy(3, 3, 3, 0, 0, 0), 0, cell.Now, MarkerTracking.Tracking),
            };
            for (var i = 0; i < 10; i++)
            {
                cell.Frame();
                var beside = cell.Base * RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0);
                sightings[0] = new MarkerSighting("d", "d", beside, 0, cell.Now, MarkerTracking.Tracking);
                cell.Tracker.Tick(cell.Now, sightings, null, null);
            }
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));

            cell.Tracker.Use("cell", markers);
            cell.Run(0.1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(cell.Tracker.Words, Does.StartWith(BaseStatusMessages.Locked(markers.Length)));
        }

        [Test]
        public void Tick_SecondPrintOfTheSameCode_StillMonitorsTheFirstPrint()
        {
            var cell = NoisyOne();
            var others = new MarkerSighting[1];
            void Other()
            {
                others[0] = new MarkerSighting("2", "a", RigidTransform.FromXyzRpy(2, 2, 0, 0, 0, 0), 0, cell.Now, MarkerTracking.Tracking);
                cell.Tracker.Tick(cell.Now, others, null, null);
            }

            cell.Run(2, Other);
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.35, 0, 0, 0, 0, 0.4);
            cell.Run(1, Other);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(cell.Tracker.Markers[0].DeviationMetres, Is.EqualTo(0.05).Within(0.003));
        }

        [Test]
        public void Tick_OldAndNewSightingOfOneCode_CountsTheOldSightingOnce()
        {
            var cell = NoisyOne();
            var old = new[] { new MarkerSighting("0", "a", cell.Base, 0, cell.Now - Lengths.Seconds(3), MarkerTracking.Tracking) };

            cell.Run(1, () => cell.Tracker.Tick(cell.Now, old, null, null));

            Assert.That(cell.Tracker.Markers[0].Ignored[SightingFault.Old], Is.EqualTo(1));
        }

        [Test]
        public void Tick_MovedMarkerPutBack_BaseIsLockedAgain()
        {
            var cell = NoisyOne();
            cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.35, 0, 0, 0, 0, 0.4);
            cell.Run(1);
            cell.Shifted.Clear();

            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        // The angles that a device reports drift independently of each other. A robot that turns, turns all its markers.
        [TestCase(1, false)]
        [TestCase(0, true)]
        public void Tick_ThreePrintsTurn_IsReportedIfTheyTurnTogether(double apartDegrees, bool isMoved)
        {
            for (var seed = 1; seed <= 5; seed++)
            {
                var cell = SimulatedMarkers.Three(seed);
                cell.Noisy();
                Locked(cell);
                var together = isMoved ? PoseNumbers.Turn(0, 0, Degree) : RigidTransform.Identity;
                for (var i = 0; i < 3; i++)
                {
                    var (x, y) = (apartDegrees * Degree * Math.Cos(2 * Math.PI / 3 * i), apartDegrees * Degree * Math.Sin(2 * Math.PI / 3 * i));
                    var place = cell.Tracker.Markers[i].Marker.MarkerInBase;
                    cell.Shifted[cell.Tracker.Markers[i].Marker.Payload] =
                        together * (PoseNumbers.Turn(x, y, 0) * place).MovedTo(place.X, place.Y, place.Z);
                }

                cell.Run(isMoved ? 1 : 10, () => Assert.That(isMoved || cell.Tracker.State == BaseAnchorState.Locked, Is.True, "seed " + seed));

                var expected = isMoved ? BaseAnchorState.Moved : BaseAnchorState.Locked;
                Assert.That(cell.Tracker.State, Is.EqualTo(expected), "seed " + seed);
            }
        }

        [Test]
        public void Tick_OnePrintInViewTurns_IsReported()
        {
            var cell = SimulatedMarkers.Three(1);
            cell.Noisy();
            Locked(cell);
            cell.IsInView = payload => payload == "a";
            cell.Run(3);

            cell.Shifted["a"] = cell.Tracker.Markers[0].Marker.MarkerInBase * PoseNumbers.Turn(0, Degree, 0);
            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
        }

        [Test]
        public void Tick_OneOfThreeMarkersMoved_NamesTheMarker()
        {
            var cell = SimulatedMarkers.Three(3);
            cell.Noisy();
            Locked(cell);
            cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.1, 0.3, 0, 0, 0, 2);

            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(Array.ConvertAll(new[] { 0, 1, 2 }, i => cell.Tracker.Markers[i].HasMoved), Is.EqualTo(new[] { false, true, false }));
        }
    }
}
