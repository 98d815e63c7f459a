using System;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring.Sequences
{
    /// <summary>
    /// Replays sequences of two markers as devices report them: six readings per second, each of them repeated in many frames. Some readings are
    /// wrong.
    /// </summary>
    public class MarkerSequenceTests
    {
        static MarkerSequence Locked(string file, double until = 4.5)
        {
            var played = new MarkerSequence(file);
            played.Play(until);
            Assert.That(played.Tracker.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(played.OffMetres, Is.LessThan(0.002));
            Assert.That(played.OffDegrees, Is.LessThan(0.5));
            return played;
        }

        /// <summary>Replays the sequence until the given time and asserts that the base does not move.</summary>
        static void Stays(MarkerSequence played, double until)
        {
            var before = played.Tracker.Base.Value;
            played.Play(until, () =>
            {
                Assert.That(played.Tracker.State, Is.EqualTo(BaseAnchorState.Locked), played.Seconds + " s: " + played.Tracker.Words);
                Assert.That(played.Tracker.Shown.Value.DistanceTo(before), Is.EqualTo(0), played.Seconds + " s");
            });
        }

        [Test]
        public void Play_NoiseAndOutliers_LocksAtTheBase()
        {
            var played = Locked("noise.txt");

            Stays(played, 8);
            Assert.That(played.Tracker.Lock.Markers, Is.EqualTo(2));
            Assert.That(played.Tracker.Lock.SpreadMetres, Is.InRange(0.0005, 0.003));
        }

        [Test]
        public void Play_StalePosesMarkedAsTracked_DoNotMoveTheBase()
        {
            var played = Locked("stale.txt");

            Stays(played, 10);
            Assert.That(played.Tracker.Markers[0].Fault, Is.EqualTo(SightingFault.Old));
        }

        [Test]
        public void Play_JumpsToTheOrigin_DoNotMoveTheBase()
        {
            var played = new MarkerSequence("origin.txt");
            played.Play(0.3);
            Assert.That(played.Tracker.Markers[0].Fault, Is.EqualTo(SightingFault.AtOrigin));
            played.Play(4.5);
            Assert.That(played.OffMetres, Is.LessThan(0.002));

            Stays(played, 10);
            Assert.That(played.Tracker.Markers[0].Ignored[SightingFault.AtOrigin], Is.GreaterThan(8));
            Assert.That(played.Tracker.Markers[0].Ignored[SightingFault.NoPose], Is.GreaterThan(2));
        }

        [Test]
        public void Play_MarkersLostAndFoundAgain_BaseStaysLocked()
        {
            var played = Locked("lost-and-back.txt");
            var before = played.Tracker.Markers[0].Sightings;

            Stays(played, 11);
            Assert.That(played.Tracker.Markers[0].Ignored[SightingFault.NotTracked], Is.GreaterThan(0));
            Assert.That(played.Tracker.Markers[0].Sightings - before, Is.GreaterThan(15), "new sightings are counted again");
        }

        [Test]
        public void Play_TwoMarkersDisagree_DoesNotLockAndNamesBothMarkers()
        {
            var played = new MarkerSequence("two-disagree.txt");

            played.Play(8);

            Assert.That(played.Tracker.State, Is.EqualTo(BaseAnchorState.Searching));
            Assert.That(played.Tracker.Words, Does.Match(
                "^" + BaseStatusMessages.Conflict("marker 'left'", "marker 'right'", "(25|26|27) mm, .+") + "$"));
        }

        [Test]
        public void Play_OneMarkerMoved_IsReportedWithinASecondAndBaseStays()
        {
            var played = Locked("one-moved.txt", 6);
            var before = played.Tracker.Base.Value;
            var detectedAt = double.NaN;

            played.Play(10, () =>
            {
                if (double.IsNaN(detectedAt) && played.Tracker.State == BaseAnchorState.Moved) detectedAt = played.Seconds;
            });

            Assert.That(detectedAt, Is.InRange(6.1, 7.0), "six readings a second");
            Assert.That(played.Tracker.Words, Does.Match("^marker 'right' is (29|30|31) mm, "));
            Assert.That(played.Tracker.Base.Value.DistanceTo(before), Is.EqualTo(0));
        }
    }
}
