using System;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity.Status
{
    public class BodyFollowingTests
    {
        const float Frame = 1 / 60f;
        static readonly FollowSettings Settings = new FollowSettings(1.3f, 12, 35, 0.4f, 0.4f);

        BodyFollowing _following;
        Pose _panel;

        static Pose Head(float yaw, float pitch = 0, float roll = 0, Vector3 position = default) =>
            new Pose(position, Quaternion.Euler(pitch, yaw, roll));

        static float Azimuth(Pose pose, Vector3 head = default) =>
            Mathf.Atan2(pose.position.x - head.x, pose.position.z - head.z) * Mathf.Rad2Deg;

        void Step(Pose head, double seconds = Frame)
        {
            for (var i = 0; i < Math.Max(1, Math.Round(seconds / Frame)); i++) _panel = _following.Next(_panel, head, Settings, Frame);
        }

        [SetUp]
        public void Begin()
        {
            _following = default;
            _panel = new Pose(new Vector3(7, 7, 7), Quaternion.Euler(10, 20, 30));
            Step(Head(0));
        }

        [TestCase(0)]
        [TestCase(90)]
        [TestCase(-170)]
        public void Next_FirstFrame_IsUprightInFrontOfTheHead(float yaw)
        {
            _following = default;
            var eyes = new Vector3(1, 1.6f, -2);

            Step(Head(yaw, 20, 15, eyes));

            Assert.That(Vector3.Distance(_panel.position, eyes), Is.EqualTo(1.3f).Within(1e-4));
            Assert.That(Mathf.DeltaAngle(Azimuth(_panel, eyes), yaw), Is.EqualTo(0).Within(0.01), "straight ahead, ignoring pitch and roll");
            Assert.That(_panel.position.y - eyes.y, Is.EqualTo(-1.3 * Math.Sin(12 * Math.PI / 180)).Within(1e-4));
            Assert.That((_panel.rotation * Vector3.up).y, Is.EqualTo(1).Within(1e-5), "upright");
            var away = _panel.position - eyes;
            away.y = 0;
            Assert.That(Vector3.Angle(_panel.rotation * Vector3.forward, away), Is.LessThan(0.1f));
        }

        [Test]
        public void Next_HeadWithinTheThreshold_DoesNotMove()
        {
            var random = new System.Random(5);
            var before = _panel;
            for (var i = 0; i < 5000; i++)
            {
                float Within(float limit) => (float)((random.NextDouble() * 2 - 1) * limit);
                Step(Head(Within(30), Within(60), Within(40), new Vector3(Within(0.05f), Within(0.2f), Within(0.2f))));

                Assert.That(_panel.position.Equals(before.position) && _panel.rotation.Equals(before.rotation), Is.True, "seed 5, step " + i);
            }
        }

        [TestCase(36)]
        [TestCase(-60)]
        [TestCase(179)]
        [TestCase(-179.9f)]
        public void Next_HeadTurnedBeyondTheThreshold_MovesWithoutAJumpAndSettles(float yaw)
        {
            var fastest = 0f;
            var nearest = float.MaxValue;
            for (var i = 0; i < 300; i++)
            {
                var before = _panel;
                Step(Head(yaw));
                fastest = Mathf.Max(fastest, Vector3.Distance(before.position, _panel.position));
                nearest = Mathf.Min(nearest, _panel.position.magnitude);
            }

            Assert.That(Mathf.Abs(Mathf.DeltaAngle(Azimuth(_panel), yaw)), Is.LessThan(0.6f));
            Assert.That(fastest, Is.InRange(1e-3f, 0.2f), "metres per frame");
            Assert.That(nearest, Is.EqualTo(1.3f).Within(0.02f), "the panel moves around the head, not through it");
            Assert.That(_following.IsGliding, Is.False);
        }

        [Test]
        public void Next_Settled_DoesNotMove()
        {
            Step(Head(60), 5);
            var settled = _panel;

            Step(Head(60 - 34), 5);
            Step(Head(60 + 34), 5);

            Assert.That(_panel.position.Equals(settled.position), Is.True);
        }

        [Test]
        public void Next_HeadTurnsBackDuringTheMove_CompletesTheMove()
        {
            Step(Head(60), 0.1);
            var onTheWay = Azimuth(_panel);

            Step(Head(20), 5);

            Assert.That(onTheWay, Is.InRange(5, 50));
            Assert.That(Azimuth(_panel), Is.EqualTo(20).Within(0.6), "the panel does not stop at the edge of the threshold");
        }

        [Test]
        public void Next_FramesOfAnyLength_ReachTheSamePlace([Values(0.004f, 0.016f, 0.1f, 1f)] float frame)
        {
            for (var t = 0f; t < 0.5f; t += frame) _panel = _following.Next(_panel, Head(60), Settings, frame);
            for (var t = 0f; t < 8; t += frame) _panel = _following.Next(_panel, Head(60), Settings, frame);

            Assert.That(Azimuth(_panel), Is.EqualTo(60).Within(0.6));
        }

        [TestCase(0, 0, 0.5f)]
        [TestCase(0, 0, -0.5f)]
        [TestCase(0, 0.5f, 0)]
        [TestCase(3, 0, 3)]
        public void Next_HeadMovedBeyondTheThreshold_FollowsUpright(float x, float y, float z)
        {
            var head = Head(10, -30, 20, new Vector3(x, y, z));

            Step(head, 6);

            Assert.That(Vector3.Distance(_panel.position, head.position), Is.EqualTo(1.3f).Within(0.02f));
            Assert.That((_panel.rotation * Vector3.up).y, Is.EqualTo(1).Within(1e-5));
        }

        [TestCase(89, 25)]
        [TestCase(-89, 25)]
        [TestCase(90, -100)]
        public void HeadingOf_LookingStraightDownOrUp_IsTheYaw(float pitch, float yaw)
        {
            Assert.That(Mathf.DeltaAngle(AroundHead.HeadingOf(Quaternion.Euler(pitch, yaw, 0)), yaw), Is.EqualTo(0).Within(0.1));
        }

        [Test]
        public void Next_NoTimePasses_DoesNotMove()
        {
            var before = _panel.position;

            _panel = _following.Next(_panel, Head(60), Settings, 0);

            Assert.That(Vector3.Distance(_panel.position, before), Is.LessThan(1e-5f));
        }
    }
}
