using System;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests a base that a person corrects by a small amount.</summary>
    public class NudgedBaseTests : AnchoredBaseFixture
    {
        /// <summary>Nudges the base by 20 mm along its x axis.</summary>
        RigidTransform Nudge()
        {
            var nudged = Tracker.Base.Value * Shift(0.02);
            Tracker.Nudge(nudged);
            _cell.Run(1);
            return nudged;
        }

        [Test]
        public void Nudge_LockedByMarkers_StaysLockedAndTheDeviceHoldsAndStoresTheNewPose()
        {
            Lock();

            var nudged = Nudge();

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Tracker.Base.Value.DistanceTo(nudged), Is.LessThan(1e-9));
            Assert.That(Tracker.Shown.Value.DistanceTo(nudged), Is.LessThan(1e-9));
            Assert.That(_anchors.Held.Single().Pose.Value.DistanceTo(nudged), Is.LessThan(1e-9));
            Assert.That(_anchors.Kept["cell"].DistanceTo(nudged), Is.LessThan(1e-9));
        }

        [Test]
        public void Nudge_Repeated_StatesTheSumWithTheRemedy()
        {
            Lock();
            Nudge();

            Nudge();

            Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Locked(3) + BaseStatusMessages.NudgedBy("40.0", "0.00")));
        }

        [Test]
        public void Nudge_MarkersInView_AreMonitoredButDoNotChangeTheBase()
        {
            Lock();
            var nudged = Nudge();
            _cell.Run(3);
            Assert.That(Tracker.Base.Value.DistanceTo(nudged), Is.LessThan(1e-9));

            _cell.Shifted["a"] = RigidTransform.FromXyzRpy(0.2, 0, 0, 0, 0, 0.4);
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
            Assert.That(Tracker.Markers[0].DeviationMetres, Is.EqualTo(0.0268).Within(0.001));
            _cell.Shifted.Clear();
            _cell.Run(1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        // Marker d was not measured relative to the nudged base.
        [Test]
        public void Nudge_MarkerOutsideTheLockInView_IsNotCompared()
        {
            _cell.IsInView = payload => payload != "c";
            Lock();
            Nudge();

            _cell.IsInView = _ => true;
            _cell.Run(3);

            Assert.That((Tracker.State, Tracker.Lock.Markers), Is.EqualTo((BaseAnchorState.Locked, 2)));
        }

        [Test]
        public void Nudge_NextRun_RestoresTheNudgedPose()
        {
            Lock();
            var nudged = Nudge();
            var next = SimulatedMarkers.Three(2);
            (next.Anchors, next.IsInView) = (_anchors, _ => false);

            next.Run(1);

            Assert.That(next.Tracker.State, Is.EqualTo(BaseAnchorState.Restored));
            Assert.That(next.Tracker.Base.Value.DistanceTo(nudged), Is.LessThan(1e-9));
        }

        [Test]
        public void Nudge_MarkerHasMoved_LocksByHandUntilTheNextLock()
        {
            Lock();
            _cell.Base = Shift(0.02) * _cell.Base;
            _cell.Run(1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Moved));

            var nudged = Nudge();

            Assert.That((Tracker.State, Tracker.Words), Is.EqualTo((BaseAnchorState.Locked, BaseStatusMessages.Placed)));
            Assert.That(_anchors.Held.Single().Pose.Value.DistanceTo(nudged), Is.LessThan(1e-9));
            Tracker.Relock();
            Lock();
            Assert.That(Tracker.Base.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9));
        }

        // The search has released the markers of the lock, so all markers in view are compared with the base, and lock it again.
        [Test]
        public void Relock_NudgedAndNoMarkerInView_MonitorsTheMarkersAgain()
        {
            Lock();
            Tracker.Nudge(Tracker.Base.Value * Shift(0.003));
            _cell.IsInView = _ => false;
            Tracker.Relock();
            _cell.Run(20);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));

            _cell.Base = Shift(0.3) * _cell.Base;
            _cell.IsInView = _ => true;
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
        }

        [Test]
        public void Relock_LockedByHandAndNoMarkerInView_StaysLockedByHand()
        {
            Lock();
            _cell.Base = Shift(0.02) * _cell.Base;
            _cell.Run(1);
            var nudged = Nudge();
            _cell.IsInView = _ => false;
            Tracker.Relock();
            _cell.Run(20);

            _cell.IsInView = _ => true;
            _cell.Run(4);

            Assert.That((Tracker.State, Tracker.Words), Is.EqualTo((BaseAnchorState.Locked, BaseStatusMessages.Placed)));
            Assert.That(Tracker.Base.Value.DistanceTo(nudged), Is.LessThan(1e-9));
        }

        [Test]
        public void Nudge_RestoredWithoutMarkers_IsHeldAtTheNewPose()
        {
            _anchors.Kept["cell"] = Shift(1);
            Tracker.Use("cell", Array.Empty<BaseMarker>());
            _cell.IsInView = _ => false;
            _cell.Run(0.1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Restored));

            var nudged = Nudge();

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(_anchors.Kept["cell"].DistanceTo(nudged), Is.LessThan(1e-9));
        }

        [Test]
        public void Nudge_BeforeTheFirstLock_CountsAsPlacedAndTheSearchContinues()
        {
            Tracker.Nudge(Shift(1));

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Lock();
        }

        [Test]
        public void Resume_NudgedBaseWithoutAnchor_SearchesForTheMarkersAgain()
        {
            _cell.Anchors = null;
            Lock();
            Nudge();

            Tracker.Resume(_cell.Now);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
        }
    }
}
