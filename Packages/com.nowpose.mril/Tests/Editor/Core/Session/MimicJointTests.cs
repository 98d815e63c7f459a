using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests mimic joints that have samples of their own, and those whose own samples have ended.</summary>
    public class MimicJointTests
    {
        static readonly int Grip = TestRobot.Model.IndexOfMovingJoint("grip");
        static readonly int Mirror = TestRobot.Model.IndexOfMovingJoint("grip_mirror");

        JointTracks _tracks;
        double _now;

        [SetUp]
        public void Begin()
        {
            _tracks = new JointTracks(TestRobot.Model, new PredictionSettings("linear"));
            _now = 100;
            // The gripper measures both fingers, and the second finger has a constant deviation of 1 mm.
            Send(1, mirrorOffset: 0.001);
        }

        [Test]
        public void Predict_OwnSamples_ShowsThem()
        {
            Predict();

            Assert.That(_tracks.Positions[Mirror], Is.EqualTo(0.001 - _tracks.Positions[Grip]).Within(1e-9));
        }

        [Test]
        public void Predict_OwnSamplesHaveEnded_FollowsItsMaster()
        {
            Send(3);

            Predict();

            Assert.That(_tracks.Positions[Grip], Is.EqualTo(0.02).Within(1e-3));
            AssertFollows();
        }

        [Test]
        public void Predict_OwnSamplesReturn_ShowsThem()
        {
            Send(3);
            Predict();

            Send(1, mirrorOffset: 0.001);
            Predict();

            Assert.That(_tracks.Positions[Mirror], Is.EqualTo(0.001 - _tracks.Positions[Grip]).Within(1e-9));
        }

        [Test]
        public void Predict_OnlyTheMasterHasSamplesAfterAReset_FollowsItsMaster()
        {
            Predict();
            _tracks.Reset();

            Send(1);
            Predict();

            AssertFollows();
        }

        // A jump to the position that follows from the master's would show a motion that did not take place.
        [Test]
        public void Predict_AllSamplesHaveEnded_KeepsTheOwnPosition([Values] bool isClockLost)
        {
            Predict();

            if (isClockLost) _tracks.Hold();
            else Predict(ahead: 5);

            Assert.That((_tracks.Kinds[Grip], _tracks.Kinds[Mirror]), Is.EqualTo((PredictionKind.Held, PredictionKind.Held)));
            Assert.That(_tracks.Positions[Mirror], Is.EqualTo(0.001 - _tracks.Positions[Grip]).Within(1e-9));
        }

        [Test]
        public void Predict_AllSamplesHaveEndedTheOwnOnesFirst_StillFollowsItsMaster()
        {
            Send(3);
            Predict();

            Predict(ahead: 5);

            Assert.That(_tracks.Kinds[Mirror], Is.EqualTo(PredictionKind.Held));
            AssertFollows();
        }

        void AssertFollows()
        {
            Assert.That(_tracks.Positions[Mirror], Is.EqualTo(-_tracks.Positions[Grip]).Within(1e-9));
            Assert.That(_tracks.Held[Mirror], Is.EqualTo(-_tracks.Held[Grip]).Within(1e-9));
            Assert.That(_tracks.Kinds[Mirror], Is.EqualTo(_tracks.Kinds[Grip]));
        }

        // The finger moves by 5 mm/s. The mirrored finger is only in the message if it has an offset.
        void Send(double seconds, double? mirrorOffset = null)
        {
            for (var end = _now + seconds - 1e-9; _now < end; _now += 0.02)
            {
                var grip = 0.005 * (_now - 100);
                _tracks.Add(
                    new JointStateMessage(ControlTime.FromSeconds(_now), new[] { "grip", "grip_mirror" }, new[] { grip, (mirrorOffset ?? 0) - grip }),
                    new[] { Grip, mirrorOffset.HasValue ? Mirror : -1 });
            }
        }

        void Predict(double ahead = 0.05) => _tracks.Predict(ControlTime.FromSeconds(_now - 0.02 + ahead));
    }
}
