using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;
using static Nowpose.Tests.Core.Anchoring.LockedMarkers;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests the first lock of a base by the markers in view.</summary>
    public class BaseTrackerTests
    {
        [Test]
        public void Tick_MarkersWithoutNoise_LocksExactlyAtTheBase()
        {
            foreach (var cell in new[] { SimulatedMarkers.One(1, 0.3), SimulatedMarkers.Three(1) })
            {
                Locked(cell);

                var (metres, degrees) = cell.ErrorAt();
                Assert.That(metres, Is.LessThan(1e-9));
                Assert.That(degrees, Is.LessThan(1e-6));
                Assert.That(cell.Tracker.Shown.Value.DistanceTo(cell.Base), Is.LessThan(1e-9), "the first lock is shown without easing");
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

        // The marker may have been moved meanwhile.
        [Test]
        public void Tick_MarkerOutOfViewForLong_IsObservedForTheWholeTimeAgain()
        {
            var cell = SimulatedMarkers.One(1, 0);
            cell.Run(1.8);
            cell.IsInView = _ => false;
            cell.Run(10);
            cell.IsInView = _ => true;

            cell.Run(1.8);
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(cell.RunUntilLocked(1), Is.Not.Null);
        }

        // A HoloLens 2 reports a code about twice a second, some tenths of a second later.
        [TestCase(0.5, 0.0, 8)]
        [TestCase(0.5, 0.6, 9)]
        [TestCase(1, 0.6, 15)]
        [TestCase(1.7, 0.25, 25)]
        public void Tick_MarkerSeenRarelyAndReportedLate_LocksAfterEnoughSightings(double interval, double delay, double atMost)
        {
            var cell = SimulatedMarkers.One(1, 0);
            cell.Noisy();
            cell.OutlierShare = 0;
            cell.ReportRarely(interval, delay);

            var took = cell.RunUntilLocked(60);

            Assert.That(took, Is.InRange(3.0, atMost));
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

        // A source that computes the pose from four corners may report two poses in turn, one of them tilted. The more frequent one may be wrong.
        [TestCase(0.45)]
        [TestCase(0.55)]
        public void Tick_PosesAlternate_DoesNotLockAndStatesIt(double tilted)
        {
            var random = new Random(1);
            var cell = SimulatedMarkers.One(1, 0.3);
            (cell.NoiseMetres, cell.NoiseDegrees) = (0.002, 0.5);
            cell.Change = sighting => random.NextDouble() > tilted ? sighting : new MarkerSighting(
                sighting.Id, "a", sighting.Pose * PoseNumbers.Turn(0.35, 0, 0), 0, sighting.LastSeen, MarkerTracking.Tracking);

            Assert.That(cell.RunUntilLocked(10), Is.Null);

            Assert.That(cell.Tracker.Words, Is.EqualTo(BaseStatusMessages.Alternates(MarkerName.Of("a"))));
        }

        // The device corrects its map by a few millimetres. Afterwards all poses agree again.
        [Category("Study")]
        [TestCase(1, 0.7)]
        [TestCase(1, 1.2)]
        [TestCase(3, 0.7)]
        [TestCase(3, 1.2)]
        public void Tick_OneStepOfThePoses_IsNotAlternating(int count, double at)
        {
            for (var seed = 1; seed <= 20; seed++)
            {
                var cell = count == 1 ? SimulatedMarkers.One(seed, 0.3) : SimulatedMarkers.Three(seed);
                (cell.NoiseMetres, cell.NoiseDegrees) = (0.0003, 0.1);
                cell.Run(at);
                cell.Base = RigidTransform.FromXyzRpy(0.003, 0, 0, 0, 0, 0) * cell.Base;

                var took = default(double?);
                cell.Run(6 - at, () =>
                {
                    Assert.That(cell.Tracker.Words, Does.Not.StartWith(BaseStatusMessages.Alternates(MarkerName.Of("a"))), "seed " + seed);
                    if (cell.Tracker.State == BaseAnchorState.Locked) took ??= cell.Seconds;
                });

                Assert.That(took, Is.LessThan(at + 2.2), "seed " + seed);
            }
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

            Assert.That(took, Is.InRange(1.8, 2.5), "seconds since the marker is in view again");
            Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.003));
        }

        [Test]
        public void Tick_MarkerInViewOnlyBriefly_DoesNotLock()
        {
            var cell = SimulatedMarkers.One(1, 0.3);
            cell.Noisy();
            cell.IsInView = _ => cell.Seconds % 5 < 0.1;

            Assert.That(cell.RunUntilLocked(40), Is.Null);
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
                Assert.That(cell.Tracker.Words, Is.EqualTo(BaseStatusMessages.Moving("marker 'a'")));

                Assert.That(cell.RunUntilLocked(3), Is.Not.Null, "seed " + seed);
                Assert.That(cell.ErrorAt().Metres, Is.LessThan(0.002), "seed " + seed);
            }
        }

        [Test]
        public void Tick_ClockGoesBack_StillCountsSightings()
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
        public void Use_DuplicatePayloadOrTooManyMarkers_Throws()
        {
            var tracker = new BaseTracker(new AnchoringSettings());
            var marker = new BaseMarker("a", RigidTransform.Identity);

            var twice = Assert.Throws<InputException>(() => tracker.Use("", new[] { marker, marker }));
            Assert.That(twice.Message, Is.EqualTo(MarkerMessages.PayloadTwice("marker 'a'")));
            Assert.Throws<InputException>(() => tracker.Use("", new BaseMarker[40]));
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Placed), "no marker was accepted");
        }
    }
}
