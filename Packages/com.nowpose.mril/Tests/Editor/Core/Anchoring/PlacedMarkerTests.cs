using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests a marker that a user places by hand.</summary>
    public class PlacedMarkerTests
    {
        static readonly RigidTransform Place = RigidTransform.FromXyzRpy(1, 2, 0.5, 0, 0.1, 2);
        static readonly RigidTransform InBase = RigidTransform.FromXyzRpy(0.3, 0, 0, 0, 0, 1);

        readonly List<MarkerSighting> _sightings = new List<MarkerSighting>();
        BaseTracker _tracker;
        FakeAnchors _anchors;
        double _now;

        [SetUp]
        public void Begin()
        {
            _tracker = new BaseTracker(new AnchoringSettings());
            _anchors = new FakeAnchors();
            _now = 10;
        }

        HeadsetTime Now => HeadsetTime.FromSeconds(_now);

        void Tick(in RigidTransform pose, HeadsetTime seen, string payload = null, bool keepsUpright = false)
        {
            _now += 1 / 60.0;
            _sightings.Clear();
            _sightings.Add(new MarkerSighting("hand", payload, pose, 0, seen, MarkerTracking.Placed, keepsUpright));
            _tracker.Tick(Now, _sightings, null, _anchors);
        }

        HeadsetTime Move(int frames, string payload = null)
        {
            for (var i = frames; i >= 0; i--) Tick(Place * RigidTransform.FromXyzRpy(0.01 * i, 0, 0, 0, 0, 0), Now, payload);
            return Now - Lengths.Seconds(1 / 60.0);
        }

        [Test]
        public void Tick_MarkerMovedByHand_BaseFollows()
        {
            Tick(Place, Now);
            Assert.That(_tracker.IsBeingPlaced, Is.True);
            var elsewhere = Place * RigidTransform.FromXyzRpy(0, 0.4, 0, 0, 0, 1);

            Tick(elsewhere, Now);

            Assert.That(_tracker.Shown.Value.DistanceTo(elsewhere), Is.EqualTo(0), "the base follows the hand without easing");
            Assert.That(_tracker.State, Is.EqualTo(BaseAnchorState.Searching));
        }

        // A code on a vertical face, 0.3 m in front of the base and 0.2 m above it.
        static readonly RigidTransform OnAFace = RigidTransform.FromXyzRpy(0.3, 0, 0.2, Math.PI / 2, 0, Math.PI / 2);

        [TestCase(null, 0, 0)]
        [TestCase(null, 0.05, -0.03)]
        [TestCase(null, 2, 0.5)]
        [TestCase("a", 0.05, -0.03)]
        public void Tick_MarkerTiltedByTheHand_BaseIsUprightAndTheMarkerStays(string payload, double roll, double pitch)
        {
            var inBase = payload == null ? RigidTransform.Identity : OnAFace;
            if (payload != null) _tracker.Use("cell", new[] { new BaseMarker("a", OnAFace) });
            var expected = RigidTransform.FromXyzRpy(1, 2, 0.5, 0, 0, 2);
            var marker = expected * inBase;
            // The axis of the tilt is horizontal.
            var held = (PoseNumbers.Turn(roll, pitch, 0) * marker).MovedTo(marker.X, marker.Y, marker.Z);

            Tick(held, Now, payload, keepsUpright: true);

            Assert.That(_tracker.Shown.Value.DistanceTo(expected), Is.LessThan(1e-9));
            Assert.That(_tracker.Shown.Value.AngleTo(expected), Is.LessThan(1e-9), "rad");
        }

        [Test]
        public void Tick_MarkerUpsideDown_BaseIsUpright()
        {
            Tick(RigidTransform.FromXyzRpy(1, 2, 0.5, Math.PI, 0, 0.4), Now, keepsUpright: true);

            Assert.That(_tracker.Shown.Value.AngleTo(RigidTransform.Identity), Is.LessThan(1e-9));
        }

        [TestCase(null)]
        [TestCase("a")]
        public void Tick_MarkerReleased_LocksTheBaseWithAnAnchor(string payload)
        {
            if (payload != null) _tracker.Use("cell", new[] { new BaseMarker("a", InBase) });
            var put = Move(20, payload);

            for (var i = 0; i < 10; i++) Tick(Place, put, payload);

            var expected = payload == null ? Place : Place * InBase.Inverse;
            Assert.That(_tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(_tracker.Shown.Value.DistanceTo(expected), Is.LessThan(1e-9));
            Assert.That(_anchors.Held, Has.Count.EqualTo(1));
            Assert.That(_tracker.KeptAs, Is.EqualTo(payload == null ? null : "cell"), "without a cell name, no anchor is stored");
        }

        // A component calls Use each time it is enabled.
        [Test]
        public void Use_SameCellWithoutMarkersAgain_KeepsTheLockByHand()
        {
            _tracker.Use("cell", Array.Empty<BaseMarker>());
            var put = Move(20);
            Tick(Place, put);

            _tracker.Use("cell", Array.Empty<BaseMarker>());
            Tick(Place, put);

            Assert.That((_tracker.State, _anchors.Held.Count), Is.EqualTo((BaseAnchorState.Locked, 1)));
            Assert.That(_tracker.Base.Value.DistanceTo(Place), Is.LessThan(1e-9));
            _tracker.Use("other", Array.Empty<BaseMarker>());
            Assert.That((_tracker.State, _anchors.Held.Count), Is.EqualTo((BaseAnchorState.Placed, 0)), "another cell");
        }

        [Test]
        public void Tick_CodesSeenElsewhereLater_DoNotMoveTheBase()
        {
            var cell = SimulatedMarkers.One(1, 0.3);
            cell.Run(1);
            _tracker = cell.Tracker;
            _now = cell.Now.SinceEpoch.TotalSeconds;
            var put = Move(5);
            Tick(Place, put);

            cell.Run(5);

            Assert.That(_tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(_tracker.Base.Value.DistanceTo(Place), Is.LessThan(1e-9));
            _tracker.Relock();
            Assert.That(cell.RunUntilLocked(3), Is.Not.Null, "the codes are used when a new lock is requested");
            Assert.That(_tracker.Base.Value.DistanceTo(cell.Base), Is.LessThan(1e-9));
        }

        [Test]
        public void Place_WhileHeldByHand_EndsThePlacement()
        {
            var cell = SimulatedMarkers.One(1, 0.3);
            cell.Run(1);
            _tracker = cell.Tracker;
            _now = cell.Now.SinceEpoch.TotalSeconds;
            var put = Move(5);

            _tracker.Place(Place);
            Tick(Place, put);

            Assert.That(_tracker.IsBeingPlaced, Is.False);
            Assert.That(cell.RunUntilLocked(4), Is.Not.Null, "the search continues");
            Assert.That(_tracker.Base.Value.DistanceTo(cell.Base), Is.LessThan(1e-9));
        }

        [Test]
        public void Tick_InvalidPoseOrUnknownPayload_IsIgnored()
        {
            Tick(default, Now);
            Tick(Place, Now, "another user's");

            Assert.That(_tracker.State, Is.EqualTo(BaseAnchorState.Placed));
            Assert.That(_tracker.Base, Is.Null);
        }

        [Test]
        public void Words_UnknownPayload_NameItUntilAnotherMarkerIsPlaced()
        {
            _tracker.Use("cell", new[] { new BaseMarker("a", InBase) });
            var unknown = BaseStatusMessages.NotOfThisBase(MarkerName.Of("b"));

            Tick(Place, Now, "b");
            Assert.That(_tracker.Words, Is.EqualTo(unknown));
            Tick(Place, Now, "a");

            Assert.That(_tracker.Words, Is.EqualTo(BaseStatusMessages.BeingPlaced));
        }
    }
}
