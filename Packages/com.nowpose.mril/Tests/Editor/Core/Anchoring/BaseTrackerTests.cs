using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class BaseTrackerTests
    {
        const double Degree = Math.PI / 180;

        static SimulatedMarkers Locked(SimulatedMarkers cell)
        {
            Assert.That(cell.RunUntilLocked(3), Is.Not.Null);
            cell.Run(1);
            return cell;
        }

        static SimulatedMarkers NoisyOne(int seed = 1)
        {
            var cell = SimulatedMarkers.One(seed, 0.3);
            cell.Noisy();
            return Locked(cell);
        }

        [Test]
        public void Tick_MarkersWithoutNoise_LocksExactlyAtTheBase()
        {
            foreach (var cell in new[] { SimulatedMarkers.One(1, 0.3), SimulatedMarkers.Three(1) })
            {
                Locked(cell);

                var (metres, degrees) = cell.ErrorAt();
                Assert.That(metres, Is.LessThan(1e-9));
                Assert.That(degrees, Is.LessThan(1e-6));
                Assert.That(cell.Tracker.Shown.Value.DistanceTo(cell.Base), Is.LessThan(1e-9), "the first is shown at once");
            }
        }

        [Test]
        public void Tick_BeforeTheLockTime_Searches()
        {
            var cell = SimulatedMarkers.One(1, 0);

            cell.Run(1.8);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(cell.Tracker.Base, Is.Null);
        }

        [Test]
        public void Tick_SeenRarely_LocksAfterEnoughSightings()
        {
            var cell = SimulatedMarkers.One(1, 0);
            cell.Noisy();
            cell.OutlierShare = 0;
            var reported = cell.Now;
            // The sighting is renewed twice a second, as by devices that read codes.
            cell.Change = sighting =>
            {
                if (sighting.LastSeen - reported >= Lengths.Seconds(0.5)) reported = sighting.LastSeen;
                return new MarkerSighting("1", "a", sighting.Pose, 0, reported, MarkerTracking.Tracking);
            };

            var took = cell.RunUntilLocked(20);

            Assert.That(took, Is.InRange(3.0, 8.0));
            Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.003));
        }

        [Test]
        public void Tick_SpreadTooWide_DoesNotLock()
        {
            var cell = SimulatedMarkers.One(1, 0);
            (cell.NoiseMetres, cell.NoiseDegrees) = (0.05, 0.5);

            Assert.That(cell.RunUntilLocked(5), Is.Null);
            Assert.That(cell.Tracker.Markers[0].SpreadMetres, Is.EqualTo(0.05).Within(0.01));
        }

        // A pose that is reported repeatedly counts as one sighting: repetitions carry no information about its accuracy.
        [Test]
        public void Tick_SamePoseRepeated_NeverLocks()
        {
            var cell = SimulatedMarkers.One(1, 0, new AnchoringSettings(oldestMs: 10_000));
            MarkerSighting? first = null;
            cell.Change = sighting => first ??= sighting;

            Assert.That(cell.RunUntilLocked(8), Is.Null);
            Assert.That(cell.Tracker.Markers[0].Sightings, Is.EqualTo(1));
        }

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
        public void Tick_OriginOrNoPose_DoesNotMoveALockedBase()
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
        public void Tick_MarkerMoved_IsDetectedWithinASecondAndNotFollowed(double metres, double degrees, double saidMetres, double saidDegrees)
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
                Assert.That(marker.DeviationMetres, Is.EqualTo(saidMetres).Within(0.0025), "seed " + seed);
                Assert.That(marker.DeviationRadians / Degree, Is.EqualTo(saidDegrees).Within(0.6), "seed " + seed);
                Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), "not followed");
            }
        }

        [Test]
        public void Tick_MarkerAtRest_IsNeverReportedAsMoved()
        {
            for (var seed = 1; seed <= 10; seed++)
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
            Assert.That(cell.Seconds - start, Is.InRange(4.5, 7), "1 mm a second, 5 mm allowed");
        }

        [Test]
        public void Tick_MarkerMovedOutOfView_LocksWithNewSightings()
        {
            var cell = SimulatedMarkers.One(1, 0.3);
            cell.Noisy();
            cell.Run(1.5);
            cell.IsInView = _ => false;
            cell.Change = s => new MarkerSighting(s.Id, s.Payload, s.Pose, 0, s.LastSeen, MarkerTracking.Tracking);
            cell.Run(5);
            cell.Base = RigidTransform.FromXyzRpy(0.5, 0, 0, 0, 0, 0) * cell.Base;
            cell.IsInView = _ => true;

            var took = cell.RunUntilLocked(5);

            Assert.That(took, Is.InRange(1.8, 2.5), "seconds since it is in view again");
            Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.003));
        }

        [Test]
        public void Tick_ShortSightings_DoNotAddUpToALock()
        {
            var cell = SimulatedMarkers.One(1, 0.3);
            cell.Noisy();
            cell.IsInView = _ => cell.Seconds % 1.2 < 0.1;

            Assert.That(cell.RunUntilLocked(10), Is.Null);
        }

        [TestCase(0.005)]
        [TestCase(0.012)]
        public void Tick_MarkerIsMoving_DoesNotLock(double metresPerSecond)
        {
            for (var seed = 1; seed <= 20; seed++)
            {
                var cell = SimulatedMarkers.One(seed, 0.3);
                cell.Noisy();
                var place = cell.Base;
                var start = cell.Seconds;
                for (var frame = 0; frame < 300; frame++)
                {
                    cell.Base = RigidTransform.FromXyzRpy(metresPerSecond * (cell.Seconds - start), 0, 0, 0, 0, 0) * place;
                    cell.Frame();
                    Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching), "seed " + seed + " at " + cell.Seconds + " s");
                }
                Assert.That(cell.Tracker.Words, Is.EqualTo("marker 'a' is moving: keep it and the robot still"));

                Assert.That(cell.RunUntilLocked(3), Is.Not.Null, "seed " + seed);
                Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.002), "seed " + seed);
            }
        }

        [Test]
        public void Use_MovedMarkerRemoved_LocksByTheOthers()
        {
            var cell = Locked(SimulatedMarkers.Three(1));
            cell.IsInView = payload => payload == "a";
            cell.Run(1);
            var markers = new[] { cell.Tracker.Markers[0].Marker, cell.Tracker.Markers[1].Marker, cell.Tracker.Markers[2].Marker };
            // A marker that was not used for the lock.
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
            Assert.That(cell.Tracker.Words, Does.StartWith("locked by"));
        }

        [Test]
        public void Tick_SecondPrintOfTheSameCode_StillMonitorsTheFirst()
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
        public void Tick_ContradictingMarkerRemoved_LocksByTheOther()
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
        public void Relock_NoMarkerInView_RestoresTheFormerLock()
        {
            var cell = NoisyOne();
            var before = cell.Tracker.Base.Value;
            cell.IsInView = _ => false;
            cell.Change = s => new MarkerSighting(s.Id, s.Payload, s.Pose, 0, s.LastSeen, MarkerTracking.Limited);
            cell.Tracker.Relock();

            cell.Run(14.5);
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
            cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.36, 0, 0, 0, 0, 0.4);
            (cell.IsInView, cell.Change) = (_ => true, s => s);
            cell.Run(1);
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved), "it is watched");
        }

        [Test]
        public void Place_ByHand_NextLockEasesFromThere()
        {
            var cell = NoisyOne();
            var nudged = RigidTransform.FromXyzRpy(0.05, 0, 0, 0, 0, 0) * cell.Tracker.Base.Value;
            cell.Tracker.Place(nudged);
            Assert.That(cell.Tracker.Shown, Is.Null, "it stands where it was put");
            cell.Tracker.Relock();

            Assert.That(cell.RunUntilLocked(3), Is.Not.Null);

            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.EqualTo(0.05).Within(0.002));
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(nudged), Is.LessThan(0.01), "it does not jump");
        }

        [Test]
        public void Tick_ClockGoesBack_CountsTheMarkerAgain()
        {
            var tracker = new BaseTracker(new AnchoringSettings());
            tracker.Use("", new[] { new BaseMarker("a", RigidTransform.Identity) });
            var pose = RigidTransform.FromXyzRpy(1, 0, 0, 0, 0, 0);
            foreach (var start in new[] { 1000.0, 10.0 })
            {
                for (var i = 0; i < 30; i++)
                {
                    var now = HeadsetTime.FromSeconds(start + i / 30.0);
                    tracker.Tick(now, new[] { new MarkerSighting("1", "a", pose, 0, now, MarkerTracking.Tracking) }, null, null);
                }
            }

            Assert.That(tracker.Markers[0].Sightings, Is.EqualTo(60));
        }

        [Test]
        public void Tick_OldAndNewSightingOfOneCode_IgnoresTheOldOnce()
        {
            var cell = NoisyOne();
            var old = new[] { new MarkerSighting("0", "a", cell.Base, 0, cell.Now - Lengths.Seconds(1), MarkerTracking.Tracking) };

            cell.Run(1, () => cell.Tracker.Tick(cell.Now, old, null, null));

            Assert.That(cell.Tracker.Markers[0].Ignored[SightingFault.Old], Is.EqualTo(1));
        }

        [Test]
        public void Tick_MarkerPutBack_IsLockedAgain()
        {
            var cell = NoisyOne();
            cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.35, 0, 0, 0, 0, 0.4);
            cell.Run(1);
            cell.Shifted.Clear();

            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        [Test]
        public void Relock_BaseMoved_EasesOverAndReportsTheChange()
        {
            var cell = NoisyOne();
            cell.Base = RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0) * cell.Base;
            cell.Run(1);
            cell.Tracker.Relock();
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            RigidTransform before = cell.Tracker.Shown.Value, last = before;
            double fastest = 0;

            cell.Run(1.8, () => Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), "it stays until it is known"));
            cell.Run(2, () =>
            {
                fastest = Math.Max(fastest, cell.Tracker.Shown.Value.DistanceTo(last));
                last = cell.Tracker.Shown.Value;
            });

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.EqualTo(0.1).Within(0.003));
            Assert.That(fastest, Is.LessThan(0.1 * 0.1), "in one frame");
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(cell.Base), Is.LessThan(0.003));
        }

        [Test]
        public void Tick_OneOfThreeMoved_NamesThatMarker()
        {
            var cell = SimulatedMarkers.Three(3);
            cell.Noisy();
            Locked(cell);
            cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.1, 0.3, 0, 0, 0, 2);

            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(Array.ConvertAll(new[] { 0, 1, 2 }, i => cell.Tracker.Markers[i].HasMoved), Is.EqualTo(new[] { false, true, false }));
        }

        [Test]
        public void Tick_TwoMarkersDisagree_DoesNotLockAndNamesBoth()
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
        public void Tick_OneOfThreeMarkersMisplaced_LocksByTheOthersAndNamesIt(double x, double y, double z)
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
                Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked), "what is known to be wrong does not move");
            }
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
            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.InRange(1e-6, 0.01), "and says by how much");
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
        public void Tick_SameCodeInTwoPlaces_IgnoresBoth()
        {
            var cell = SimulatedMarkers.One(1, 0);
            var other = false;
            cell.Change = sighting => (other = !other)
                ? sighting
                : new MarkerSighting("2", "a", sighting.Pose * RigidTransform.FromXyzRpy(1, 0, 0, 0, 0, 0), 0, cell.Now, MarkerTracking.Tracking);

            Assert.That(cell.RunUntilLocked(6), Is.Null);
            Assert.That(cell.Tracker.Markers[0].Ignored[SightingFault.TwoPlaces], Is.GreaterThan(50));
        }

        [Test]
        public void Use_DuplicatePayloadOrTooManyMarkers_Throws()
        {
            var tracker = new BaseTracker(new AnchoringSettings());
            var marker = new BaseMarker("a", RigidTransform.Identity);

            var twice = Assert.Throws<InputException>(() => tracker.Use("", new[] { marker, marker }));
            Assert.That(twice.Message, Is.EqualTo("marker 'a' is given twice; each marker of a base needs its own payload"));
            Assert.Throws<InputException>(() => tracker.Use("", new BaseMarker[40]));
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Placed), "nothing was taken");
        }

        // A headset reads the cell's codes one after the other.
        [Test]
        public void Use_AnotherMarkerOfTheSameCell_KeepsAndImprovesTheLock()
        {
            var cell = NoisyOne();
            var one = RigidTransform.FromXyzRpy(0.3, 0, 0, 0, 0, 0.4);

            cell.Use(("a", one), ("b", RigidTransform.FromXyzRpy(-0.3, 0, 0, 0, 0, 1)));

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            cell.Run(4);
            Assert.That(cell.Tracker.Lock.Markers, Is.EqualTo(2));
        }

        [Test]
        public void Use_MarkerWithNewPlace_LocksAgainWithoutAJump()
        {
            var cell = NoisyOne();
            var before = cell.Tracker.Shown.Value;

            cell.Use(("a", RigidTransform.FromXyzRpy(0.4, 0, 0, 0, 0, 0.4)));

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            cell.Run(0.1);
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
        }

        [Test]
        public void Use_AnotherCell_ReleasesTheLock()
        {
            var cell = NoisyOne();

            cell.Tracker.Use("another", new[] { new BaseMarker("a", RigidTransform.Identity) });

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(cell.Tracker.Base, Is.Null);
        }

        [Test]
        public void Place_WithoutPose_KeepsSearchingOrReleasesTheLock()
        {
            var cell = SimulatedMarkers.One(1, 0);
            cell.Tracker.Place();
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Locked(cell);

            cell.Tracker.Place();
            cell.Run(3);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Placed));
            Assert.That(cell.Tracker.Base, Is.Null);
            cell.Tracker.Relock();
            Assert.That(cell.RunUntilLocked(3), Is.Not.Null, "until the markers are asked again");
        }
    }
}
