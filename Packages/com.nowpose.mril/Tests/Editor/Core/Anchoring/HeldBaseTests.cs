using System;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;
using Nowpose.Messages;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>
    /// Tests a base whose lock is held by a spatial anchor: hand-over to the anchor, correction, loss, and restoration in another run.
    /// </summary>
    public class HeldBaseTests : AnchoredBaseFixture
    {
        [Test]
        public void Lock_DeviceHasAnchors_IsHeldAndStoredUnderTheNameOfTheCell()
        {
            Lock();

            Assert.That(_anchors.Held.Single().Pose.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9));
            Assert.That(Tracker.KeptAs, Is.EqualTo("cell"));
            Assert.That(Tracker.IsHeld, Is.True);
        }

        [Test]
        public void Lock_Repeated_LeavesOneAnchorAtTheNewPlace()
        {
            Lock();
            _cell.Base = Shift(0.2) * _cell.Base;
            Tracker.Relock();
            Lock();
            _cell.Run(0.1);

            Assert.That(_anchors.Held.Single().Pose.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9));
            Assert.That(_anchors.Kept["cell"].DistanceTo(_cell.Base), Is.LessThan(1e-9));
        }

        [Test]
        public void Tick_DeviceCorrectsItsMap_EasesToTheNewPoseAndReportsTheChange()
        {
            Lock();
            _cell.Run(1);
            // The markers move with the corrected map.
            _cell.Base = Shift(0.05, 0.02) * _cell.Base;
            _anchors.Held[0].Pose = _cell.Base;
            RigidTransform last = Tracker.Shown.Value, before = last;
            double fastest = 0;

            _cell.Run(2, () =>
            {
                fastest = Math.Max(fastest, Tracker.Shown.Value.DistanceTo(last));
                last = Tracker.Shown.Value;
            });

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked), "no marker has moved");
            Assert.That(last.DistanceTo(_cell.Base), Is.LessThan(1e-4));
            Assert.That(fastest, Is.LessThan(0.1 * before.DistanceTo(_cell.Base)));
            Assert.That(Tracker.CorrectedMetres, Is.EqualTo(before.DistanceTo(_cell.Base)).Within(1e-6));
            Assert.That(Tracker.CorrectedRadians, Is.EqualTo(0.02).Within(1e-6));
            Assert.That(Tracker.IsCorrected, Is.True);
            Assert.That(Tracker.Words, Is.EqualTo(
                BaseStatusMessages.Locked(3) + BaseStatusMessages.Corrected((int)Math.Round(1000 * Tracker.CorrectedMetres), "1.1")));
        }

        [Test]
        public void Tick_AnchorLost_KeepsTheBaseAndReportsTheLoss()
        {
            Lock();
            var before = Tracker.Base.Value;
            (_anchors.Held[0].State, _anchors.Held[0].Problem) = (SpatialAnchorState.Lost, "switched off");
            // In another map, all poses are shifted.
            _cell.Base = Shift(2) * _cell.Base;

            _cell.Run(3);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Lost));
            Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Lost + BaseStatusMessages.Because("switched off")));
            Assert.That(Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
            _cell.Base = Shift(-2) * _cell.Base;
            _anchors.Held[0].State = SpatialAnchorState.Tracking;
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        [Test]
        public void Tick_AnchorPoseInvalid_DoesNotMoveTheBase()
        {
            Lock();
            var before = Tracker.Base.Value;
            foreach (var pose in new RigidTransform?[] { RigidTransform.Identity, default(RigidTransform), null })
            {
                _anchors.Held[0].Pose = pose;

                _cell.Run(1);

                Assert.That(Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
            }
        }

        [Test]
        public void Tick_AnchorJumpsTooFar_IsReportedAndNotFollowed()
        {
            Lock();
            var before = Tracker.Base.Value;
            _anchors.Held[0].Pose = Shift(0.31) * before;

            _cell.Run(2);

            Assert.That(Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Lost));
            Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Elsewhere("0.3", "0.0", hasMarkers: true)));
            _anchors.Held[0].Pose = Shift(0.29) * before;
            _cell.Base = _anchors.Held[0].Pose.Value;
            _cell.Run(2);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked), "a correction is followed");
            Assert.That(Tracker.CorrectedMetres, Is.EqualTo(0.29).Within(1e-6));

            _anchors.Held[0].Pose = Shift(5) * before;
            _cell.Run(1);
            Tracker.Relock();
            Lock();
            _cell.Run(3);
            Assert.That(Tracker.Shown.Value.DistanceTo(_cell.Base), Is.LessThan(1e-6));
            Assert.That(_anchors.Held, Has.Count.EqualTo(1));
        }

        [Test]
        public void Tick_AnchorFails_StaysLockedAndStatesTheReason()
        {
            _anchors.StateAtFirst = SpatialAnchorState.Failed;
            Lock();
            _anchors.Held[0].Problem = "no room for more";

            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Problem, Is.EqualTo("no room for more"));
            Assert.That(Tracker.Base.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9));
        }

        // The device removes an anchor, for example when its AR runtime restarts. The map may then be another one.
        [Test]
        public void Tick_DeviceRemovesTheAnchor_IsLostWithTheReasonUntilTheNextLock()
        {
            Lock();
            _cell.Run(1);
            var before = Tracker.Base.Value;
            (_anchors.Held[0].State, _anchors.Held[0].Problem) = (SpatialAnchorState.Failed, "no anchor");
            _cell.Base = Shift(0.4) * _cell.Base;

            _cell.Run(3);
            Assert.That((Tracker.State, Tracker.Words), Is.EqualTo((BaseAnchorState.Lost, "no anchor")));
            Assert.That(Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0));

            Tracker.Relock();
            Lock();
            _cell.Run(3);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Shown.Value.DistanceTo(_cell.Base), Is.LessThan(1e-6));
            Assert.That(_anchors.Held.Single().State, Is.EqualTo(SpatialAnchorState.Tracking));
        }

        [Test]
        public void Place_DeviceHasRemovedTheAnchor_ReleasesIt()
        {
            Lock();
            _cell.Run(1);
            _anchors.Held[0].State = SpatialAnchorState.Failed;
            _cell.Run(1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Lost));

            Tracker.Place(Shift(1));

            Assert.That((Tracker.State, Tracker.Problem), Is.EqualTo((BaseAnchorState.Placed, (string)null)));
        }

        [Test]
        public void Tick_BaseStoredInAnEarlierRun_IsRestoredAndConfirmedByMarkers()
        {
            _anchors.Kept["cell"] = Shift(0.004) * _cell.Base;
            _cell.IsInView = _ => false;
            _anchors.IsReady = false;
            _cell.Run(1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Searching));

            _anchors.IsReady = true;
            _cell.Run(1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Restored));
            Assert.That(Tracker.Shown.Value.DistanceTo(_cell.Base), Is.EqualTo(0.004).Within(1e-9));
            _cell.IsInView = _ => true;
            _cell.Run(4);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Lock.ChangeMetres, Is.EqualTo(0.004).Within(1e-6));
            Assert.That(Tracker.Shown.Value.DistanceTo(_cell.Base), Is.LessThan(1e-5));
        }

        [Test]
        public void Tick_BaseRestoredAtAWrongPlace_IsReportedAsMovedAndStays()
        {
            _anchors.Kept["cell"] = Shift(0.05) * _cell.Base;

            _cell.Run(5);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(Tracker.Base.Value.DistanceTo(_cell.Base), Is.EqualTo(0.05).Within(1e-9));
            Tracker.Relock();
            Lock();
            Assert.That(_anchors.Kept["cell"].DistanceTo(_cell.Base), Is.LessThan(1e-6), "the new pose is stored for the next run");
        }

        [Test]
        public void Relock_RestoredWithoutMarkers_ConfirmsTheBase()
        {
            _anchors.Kept["cell"] = Shift(0.004);
            Tracker.Use("cell", Array.Empty<BaseMarker>());
            _cell.IsInView = _ => false;
            _cell.Run(0.1);
            Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Restored(hasMarkers: false, null)));

            Tracker.Relock();
            _cell.Run(0.1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Base.Value.X, Is.EqualTo(0.004), "the base stays in place");
            Assert.That(_anchors.Held, Has.Count.EqualTo(1), "the device keeps the anchor");
        }

        [Test]
        public void Tick_NothingStored_SearchesForMarkers()
        {
            _anchors.Kept["another cell"] = Shift(1);
            _cell.IsInView = _ => false;

            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(_anchors.Held, Is.Empty);
        }

        [Test]
        public void Place_BeforeTheStoreIsReady_IsNotOverriddenByTheStoredBase()
        {
            _anchors.Kept["cell"] = Shift(1);
            _anchors.IsReady = false;
            _cell.IsInView = _ => false;
            _cell.Run(0.5);
            Tracker.Place(Shift(2));

            _anchors.IsReady = true;
            _cell.Run(1);

            Assert.That(Tracker.Base, Is.Null, "the base stays where the user placed it");
        }

        [Test]
        public void Lock_BeforeTheStoreIsReady_IsNotOverriddenByTheStoredBase()
        {
            _anchors.Kept["cell"] = Shift(1);
            _anchors.IsReady = false;
            Lock();

            _anchors.IsReady = true;
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Base.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9));
        }

        [TestCase(9, BaseAnchorState.Locked)]
        [TestCase(20, BaseAnchorState.Lost)]
        public void Tick_AnchorTurns_IsFollowedOnlyByTheAngleOfACorrection(double degrees, BaseAnchorState expected)
        {
            Lock();
            var (before, radians) = (Tracker.Base.Value, degrees * Math.PI / 180);

            _anchors.Held[0].Pose = _cell.Base = before * Shift(0, radians);
            _cell.Run(2);

            Assert.That(Tracker.State, Is.EqualTo(expected));
            Assert.That(Tracker.Base.Value.AngleTo(before), Is.EqualTo(expected == BaseAnchorState.Lost ? 0 : radians).Within(1e-6));
            if (expected == BaseAnchorState.Lost) Assert.That(Tracker.Words, Does.Contain("20.0°"));
        }

        [Test]
        public void Place_BaseHeldByAnAnchor_ReleasesTheAnchorAndDoesNotRestoreIt()
        {
            Lock();

            Tracker.Place();
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Placed));
            Assert.That(_anchors.Held, Is.Empty);
        }
    }
}
