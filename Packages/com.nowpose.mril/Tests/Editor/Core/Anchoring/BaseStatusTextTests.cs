using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Messages;
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
            Assert.That(new BaseTracker(new AnchoringSettings()).Words, Is.EqualTo(BaseStatusMessages.Placed));
            _cell.IsInView = _ => false;
            Assert.That(Words(9), Is.EqualTo(BaseStatusMessages.Looking(isBlind: false, null)));
            Assert.That(Words(2), Is.EqualTo(BaseStatusMessages.Looking(isBlind: true, null)));
            _cell.Tracker.SourceProblem = "no XR Origin";
            Assert.That(Words(), Is.EqualTo(BaseStatusMessages.Looking(isBlind: false, "no XR Origin")));
            _cell.Tracker.SourceProblem = null;
            Words(3);
            _cell.IsInView = _ => true;
            Assert.That(Words(3), Is.EqualTo(BaseStatusMessages.Locked(3)));
        }

        [Test]
        public void Words_FromFirstSightingToLock_StateProgress()
        {
            _cell.IsInView = payload => payload != "b";
            Assert.That(Words(1), Is.EqualTo(BaseStatusMessages.Gathers(2, 3)));
            Assert.That(Words(1), Is.EqualTo(BaseStatusMessages.Locked(2)));
        }

        [Test]
        public void Words_UnsuitableView_StateTheRemedy()
        {
            Report(RigidTransform.FromXyzRpy(1.2, -0.4, 3, 0, 1.5, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' " + BaseStatusMessages.TooFar("2.5")));
            Report(RigidTransform.FromXyzRpy(-0.3, -0.4, -0.5, 0, 0, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' " + BaseStatusMessages.TooOblique));
            Report(RigidTransform.FromXyzRpy(1.2, -0.4, 0.3, 0, -1, 0));
            Assert.That(Words(), Is.EqualTo("marker 'a' " + BaseStatusMessages.Behind));
            Report(ageSeconds: 3);
            Assert.That(Words(), Is.EqualTo("marker 'a' " + BaseStatusMessages.NotInView));
        }

        [Test]
        public void Words_NoisyMarker_StateTheSpread()
        {
            _cell.IsInView = payload => payload == "a";
            (_cell.NoiseMetres, _cell.OutlierShare) = (0.04, 0);

            Assert.That(Words(3), Does.Match("^" + BaseStatusMessages.Scatters("marker 'a'", "(3|4)\\d mm, 0\\.\\d°") + "$"));
        }

        [Test]
        public void Words_MarkerMoved_NameMarkerAndDistance()
        {
            Words(3);
            _cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866, 0.25, 0, 0, 0, 2);

            Assert.That(Words(3), Does.Match("^" + BaseStatusMessages.Moved(1, "marker 'b'", "(99|100|101) mm, 0\\.\\d°") + "$"));
            _cell.Tracker.Relock();
            Assert.That(Words(3), Does.Match("^" + BaseStatusMessages.Locked(2) + BaseStatusMessages.MovedBy("0\\.\\d", "0\\.\\d\\d")
                + BaseStatusMessages.ConflictOfLock("marker 'b'", 100, "0\\.\\d").Replace("100 mm", "(99|100|101) mm") + "$"));
        }

        [Test]
        public void Words_BaseMoved_NameAllMarkers()
        {
            Words(3);
            _cell.Base = RigidTransform.FromXyzRpy(0, 0, 0.03, 0, 0, 0) * _cell.Base;

            Assert.That(Words(1.5), Does.Match("^" + BaseStatusMessages.Moved(3, "marker '[abc]'", ".+") + "$"));
        }

        [Test]
        public void Words_ContradictingMarkers_NameBothMarkers()
        {
            _cell.IsInView = payload => payload != "c";
            _cell.Shifted["b"] = RigidTransform.FromXyzRpy(-0.0866 - 0.0433, 0.175, 0, 0, 0, 2);

            Assert.That(
                Words(3), Does.Match("^" + BaseStatusMessages.Conflict("marker 'a'", "marker 'b'", "(49|50|51) mm, \\d\\.\\d°") + "$"));
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
