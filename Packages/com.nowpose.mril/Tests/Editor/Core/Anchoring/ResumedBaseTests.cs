using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests a base after standby, when the origin of the device's poses is often elsewhere.</summary>
    public class ResumedBaseTests : AnchoredBaseFixture
    {
        void PlaceByHand(BaseTracker tracker, FakeAnchors anchors)
        {
            tracker.Tick(_cell.Now, new[] { new MarkerSighting("hand", null, _cell.Base, 0, _cell.Now, MarkerTracking.Placed) }, null, anchors);
            tracker.Tick(_cell.Now, Array.Empty<MarkerSighting>(), null, anchors);
        }

        [Test]
        public void Resume_AnchorHeld_IsFollowedHoweverFarItMovesAndConfirmedByTheMarkers()
        {
            Lock();
            _cell.Run(1);
            (_cell.IsInView, _cell.Head) = (_ => false, null);
            Tracker.Resume(_cell.Now);
            _cell.Run(2);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked), "nothing has moved yet");

            _cell.Base = Shift(1.5, 0.6) * _cell.Base;
            _anchors.Held[0].Pose = _cell.Base;
            _cell.Run(3);

            Assert.That((Tracker.State, Tracker.IsCorrected), Is.EqualTo((BaseAnchorState.Restored, false)));
            Assert.That(Tracker.Shown.Value.DistanceTo(_cell.Base), Is.LessThan(1e-4));
            _cell.IsInView = _ => true;
            Lock();
        }

        // The search ends after 15 s without a marker, and the lock from before it is not valid any more.
        [Test]
        public void Resume_DuringASearchThatEndsWithoutMarkers_IsRestoredNotLocked()
        {
            Lock();
            _cell.Run(1);
            (_cell.IsInView, _cell.Head) = (_ => false, null);
            Tracker.Resume(_cell.Now);
            Tracker.Relock();
            _cell.Run(1);
            _anchors.Held[0].Pose = Shift(1.5) * _cell.Base;

            _cell.Run(16);

            Assert.That((Tracker.State, Tracker.Lock), Is.EqualTo((BaseAnchorState.Restored, (LockReport)null)));
            Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Restored(hasMarkers: true, null)));
        }

        [Test]
        public void Resume_PlacedByHandWithMarkers_MarkersConfirmItAfterAJump()
        {
            _cell.IsInView = _ => false;
            PlaceByHand(Tracker, _anchors);
            _cell.Run(0.1);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Tracker.Resume(_cell.Now);
            _cell.Base = Shift(1.5) * _cell.Base;
            _anchors.Held[0].Pose = _cell.Base;
            _cell.Run(0.5);
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Restored));

            (_cell.IsInView, _cell.Head) = (_ => true, null);

            Lock();
        }

        [Test]
        public void Resume_WithoutMarkersAndAnchor_IsRestoredUntilItIsConfirmed()
        {
            var tracker = new BaseTracker(new AnchoringSettings());
            tracker.Use("cell", Array.Empty<BaseMarker>());
            PlaceByHand(tracker, null);
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Locked));

            tracker.Resume(_cell.Now);
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Restored));
            tracker.Relock();

            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }

        [Test]
        public void Resume_LongAgo_AnchorThatJumpsIsNotFollowed()
        {
            Lock();
            Tracker.Resume(_cell.Now);
            _cell.Run(40);

            _anchors.Held[0].Pose = Shift(1.5) * _cell.Base;
            _cell.Run(1);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Lost));
        }

        [TestCase(null)]
        [TestCase(SpatialAnchorState.Pending)]
        [TestCase(SpatialAnchorState.Failed)]
        public void Resume_NoAnchorHoldsTheBase_SearchesForTheMarkersAgain(SpatialAnchorState? state)
        {
            if (state == null) _cell.Anchors = null;
            else _anchors.StateAtFirst = state.Value;
            Lock();
            var before = Tracker.Base.Value;
            (_cell.IsInView, _cell.Head) = (_ => false, null);
            _cell.Base = Shift(1.5) * _cell.Base;

            Tracker.Resume(_cell.Now);
            _cell.Run(3);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), "the previous pose stays visible");
            _cell.IsInView = _ => true;
            Lock();
            Assert.That(_cell.ErrorAt().Metres, Is.LessThan(1e-3));
        }
    }
}
