using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;
using static Nowpose.Tests.Core.Anchoring.LockedMarkers;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests a locked base that is locked again, is placed by hand, or receives other markers.</summary>
    public class RelockTests
    {
        [Test]
        public void Relock_NoMarkerInView_RestoresThePreviousLock()
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
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Moved), "the marker is monitored again");
        }

        [Test]
        public void Relock_MarkerInViewCannotLock_SearchesUntilItIsOutOfViewForTheWholeTime()
        {
            var cell = NoisyOne();
            cell.NoiseMetres = 0.05;
            cell.Tracker.Relock();

            cell.Run(20, () => Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching)));
            cell.IsInView = _ => false;
            cell.Run(14.5, () => Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching)));
            cell.Run(1);

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        // The headset is taken off after the request.
        [Test]
        public void Relock_ApplicationPaused_SearchesForTheWholeTimeAfterThePause()
        {
            var cell = NoisyOne();
            cell.IsInView = _ => false;
            cell.Tracker.Relock();
            cell.Run(2);

            cell.Pause(60);

            cell.Run(14.5, () => Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching)));
            cell.Run(1);
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        [Test]
        public void Place_ByHand_NextLockEasesFromThePlacedPose()
        {
            var cell = NoisyOne();
            var nudged = RigidTransform.FromXyzRpy(0.05, 0, 0, 0, 0, 0) * cell.Tracker.Base.Value;
            cell.Tracker.Place(nudged);
            Assert.That(cell.Tracker.Shown, Is.Null, "the base stays where the user placed it");
            cell.Tracker.Relock();

            Assert.That(cell.RunUntilLocked(3), Is.Not.Null);

            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.EqualTo(0.05).Within(0.002));
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(nudged), Is.LessThan(0.01), "the base does not jump");
        }

        [Test]
        public void Relock_BaseMoved_EasesToTheNewPoseAndReportsTheChange()
        {
            var cell = NoisyOne();
            cell.Base = RigidTransform.FromXyzRpy(0.1, 0, 0, 0, 0, 0) * cell.Base;
            cell.Run(1);
            cell.Tracker.Relock();
            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            RigidTransform before = cell.Tracker.Shown.Value, last = before;
            double fastest = 0;

            cell.Run(1.8, () => Assert.That(cell.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), "the base stays until the new lock"));
            cell.Run(2, () =>
            {
                fastest = Math.Max(fastest, cell.Tracker.Shown.Value.DistanceTo(last));
                last = cell.Tracker.Shown.Value;
            });

            Assert.That(cell.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(cell.Tracker.Lock.ChangeMetres, Is.EqualTo(0.1).Within(0.003));
            Assert.That(fastest, Is.LessThan(0.1 * 0.1), "motion per frame");
            Assert.That(cell.Tracker.Shown.Value.DistanceTo(cell.Base), Is.LessThan(0.003));
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
        public void Use_MarkerAtANewPlace_SearchesWithoutMovingTheBase()
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
            Assert.That(cell.RunUntilLocked(3), Is.Not.Null, "a new lock uses the markers again");
        }
    }
}
