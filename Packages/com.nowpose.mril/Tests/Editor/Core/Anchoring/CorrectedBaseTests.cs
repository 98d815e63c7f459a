using System;
using System.Globalization;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests a base that the device moves far by correcting its map.</summary>
    public class CorrectedBaseTests : AnchoredBaseFixture
    {
        void Correct(in RigidTransform by, bool isInView)
        {
            (_cell.IsInView, _cell.Head) = (_ => isInView, null);
            _cell.Run(1);
            _anchors.Held[0].Pose = by * Tracker.Base.Value;
            _cell.Run(1);
        }

        [TestCase(0.25, 8, BaseAnchorState.Restored)]
        [TestCase(0.03, 0, BaseAnchorState.Restored)]
        [TestCase(0.015, 0, BaseAnchorState.Locked)]
        public void Tick_MapCorrectedWithoutMarkersInView_IsConfirmedOnlyIfTheCorrectionIsSmall(
            double metres, double degrees, BaseAnchorState expected)
        {
            Lock();
            var radians = degrees * Math.PI / 180;
            _cell.Base = Tracker.Base.Value * Shift(metres, radians);

            Correct(_cell.Base * Tracker.Base.Value.Inverse, isInView: false);

            Assert.That(Tracker.State, Is.EqualTo(expected));
            Assert.That(Tracker.Base.Value.DistanceTo(_cell.Base), Is.LessThan(1e-9), "the correction is followed");
            if (expected == BaseAnchorState.Restored)
                Assert.That(Tracker.Words, Is.EqualTo(BaseStatusMessages.Unconfirmed(
                    (int)(1000 * metres), degrees.ToString("0.0", CultureInfo.InvariantCulture), hasMarkers: true, null)));
            _cell.IsInView = _ => true;
            _cell.Run(1);
            Assert.That((Tracker.State, Tracker.Lock.Markers), Is.EqualTo((BaseAnchorState.Locked, 3)), "the markers confirm it");
            Assert.That(Tracker.CorrectedMetres, Is.EqualTo(metres).Within(1e-6));
        }

        [Test]
        public void Tick_MarkersContradictALargeCorrection_IsReportedAsMovedAndNeverConfirmed()
        {
            Lock();
            _cell.Run(1);
            _anchors.Held[0].Pose = Shift(0.05) * Tracker.Base.Value;

            _cell.Frame();
            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Restored));
            _cell.Run(1, () => Assert.That(Tracker.State, Is.Not.EqualTo(BaseAnchorState.Locked)));

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Moved));
        }

        [Test]
        public void Tick_MapCorrectedInManySteps_IsNotConfirmed()
        {
            Lock();
            for (var i = 0; i < 5; i++) Correct(Shift(0.006), isInView: false);

            Assert.That(Tracker.State, Is.EqualTo(BaseAnchorState.Restored));
        }

        // The markers are not part of the lock, so they cannot confirm it.
        [Test]
        public void Relock_LargeCorrectionOfALockByHand_ConfirmsTheBase([Values] bool isInView)
        {
            Lock();
            _cell.Base = Shift(0.05) * _cell.Base;
            _cell.Run(1);
            Tracker.Nudge(_cell.Base);
            _cell.Base = Shift(0.03) * _cell.Base;
            Correct(Shift(0.03), isInView);
            Assert.That((Tracker.State, Tracker.Words), Is.EqualTo(
                (BaseAnchorState.Restored, BaseStatusMessages.Unconfirmed(30, "0.0", hasMarkers: false, null))));
            var corrected = Tracker.Base.Value;

            Tracker.Relock();
            _cell.Run(1);

            Assert.That((Tracker.State, Tracker.Words), Is.EqualTo((BaseAnchorState.Locked, BaseStatusMessages.Placed)));
            Assert.That(Tracker.Base.Value.DistanceTo(corrected), Is.EqualTo(0));
        }

        [Test]
        public void Relock_LargeCorrectionWithoutMarkers_ConfirmsTheBase()
        {
            var tracker = new BaseTracker(new AnchoringSettings());
            tracker.Use("cell", Array.Empty<BaseMarker>());
            tracker.Tick(_cell.Now, new[] { new MarkerSighting("hand", null, _cell.Base, 0, _cell.Now, MarkerTracking.Placed) }, null, _anchors);
            void Tick() => tracker.Tick(_cell.Now, Array.Empty<MarkerSighting>(), null, _anchors);
            Tick();
            Tick();
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            _anchors.Held.Single().Pose = Shift(0.05) * _cell.Base;
            Tick();
            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Restored));

            tracker.Relock();
            Tick();

            Assert.That(tracker.State, Is.EqualTo(BaseAnchorState.Locked));
        }
    }
}
