using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>Tests the messages about the base that the wearer sees.</summary>
    public class BaseStatusTextTests
    {
        SimulatedMarkers _cell;

        [SetUp]
        public void Begin()
        {
            _cell = SimulatedMarkers.Three(2);
            _cell.Noisy();
        }

        string Words(double seconds = 0.1)
        {
            _cell.Run(seconds);
            return _cell.Tracker.Words;
        }

        void Report(RigidTransform? head = null, double ageSeconds = 0, double sizeMetres = 0)
        {
            _cell.IsInView = payload => payload == "a";
            _cell.Head = head ?? _cell.Head;
            _cell.Change = s => new MarkerSighting(
                s.Id, s.Payload, s.Pose, sizeMetres, HeadsetTime.FromSeconds(s.LastSeen.SinceEpoch.TotalSeconds - ageSeconds), s.Tracking);
        }

        [Test]
        public void Words_NoMarkers_StateTheReason()
        {
            Assert.That(new BaseTracker(new AnchoringSettings()).Words, Is.EqualTo("placed by hand"));
            _cell.IsInView = _ => false;
            Assert.That(Words(9), Is.EqualTo("looking for markers"));
            Assert.That(Words(2), Is.EqualTo("looking for markers; allow access to the camera if it is blocked"));
            _cell.Tracker.SourceProblem = "no XR Origin";
            Assert.That(Words(), Is.EqualTo("looking for markers; no XR Origin"));
            _cell.Tracker.SourceProblem = null;
            Words(3);
            _cell.IsInView = _ => true;
            Assert.That(Words(3), Is.EqualTo("locked by 3 markers"));
        }

        [Test]
        public void Words_FromFirstSightingToLock_StateProgress()
        {
            _cell.IsInView = payload => payload != "b";
            Assert.That(Words(1), Is.EqualTo("2 of 3 markers in view: keep looking at them"));
            Assert.That(Words(1), Is.EqualTo("locked by 2 markers"));
        }

        [Test]
        public void Words_UnsuitableView_StateTheRemedy()
        {
            Report(RigidTransform.FromXyzRpy(1.2, -0.4, 3, 0, 1.5, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' is too far away: move to within 2.5 m of it"));
            Report(RigidTransform.FromXyzRpy(-0.3, -0.4, -0.5, 0, 0, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' is seen too obliquely: stand in front of it"));
            Report(RigidTransform.FromXyzRpy(1.2, -0.4, 0.3, 0, -1, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' is behind you: look at it"));
            Report(ageSeconds: 1);
            Assert.That(Words(), Is.EqualTo("marker 'a' is no longer in view: look at it"));
        }

        [Test]
        public void Words_NoisyMarker_StateTheSpread()
        {
            _cell.IsInView = payload => payload == "a";
            (_cell.NoiseMetres, _cell.OutlierShare) = (0.04, 0);

            Assert.That(Words(3), Does.Match("^the poses of marker 'a' scatter by (3|4)\\d mm, 0\\.\\d°: move closer and keep still$"));
        }

        [Test]
        public void Words_MarkerMoved_NameMarkerAndDistance()
        {
            Words(3);
            _cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866, 0.25, 0, 0, 0, 2);

            Assert.That(Words(3), Does.Match("^marker 'b' is (99|100|101) mm, 0\\.\\d° from its expected position: put it back, or lock again$"));
            _cell.Tracker.Relock();
            Assert.That(Words(3), Does.Match("^locked by 2 markers, moved by 0\\.\\d mm, 0\\.\\d\\d°; "
                + "marker 'b' is (99|100|101) mm, 0\\.\\d° from where the other markers place it$"));
        }

        [Test]
        public void Words_BaseMoved_NameAllMarkers()
        {
            Words(3);
            _cell.Base = RigidTransform.FromXyzRpy(0, 0, 0.03, 0, 0, 0) * _cell.Base;

            Assert.That(Words(1.5), Does.StartWith("3 markers have moved; the worst, marker '"));
        }

        [Test]
        public void Words_ContradictingMarkers_NameBothMarkers()
        {
            _cell.IsInView = payload => payload != "c";
            _cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866 - 0.0433, 0.175, 0, 0, 0, 2);

            Assert.That(
                Words(3), Does.Match("^marker 'a' and marker 'b' disagree by (49|50|51) mm, \\d\\.\\d°: measure their poses again$"));
        }

        [Test]
        public void Words_Unchanged_ReuseTheText()
        {
            Words(3);
            var texts = new HashSet<string>();

            _cell.Run(5, () => texts.Add(_cell.Tracker.Words));
            Assert.That(texts, Has.Count.EqualTo(1));
            _cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866, 0.25, 0, 0, 0, 2);
            texts.Clear();
            _cell.Run(5, () => texts.Add(_cell.Tracker.Words));

            Assert.That(texts, Has.Count.LessThan(8), "numbers change once a second");
        }
    }
}
