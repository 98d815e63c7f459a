using System;
using Nowpose.Anchoring;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    public class BaseAnchorTests
    {
        readonly SceneObjects _scene = new SceneObjects();
        BaseAnchor _anchor;
        int _moves;

        [SetUp]
        public void MakeAnchor()
        {
            var room = _scene.New("Room");
            room.position = new Vector3(5, 0, 0);
            _anchor = _scene.New<BaseAnchor>("Base Anchor", room);
            _moves = 0;
            _anchor.Moved += () => _moves++;
        }

        [TearDown]
        public void Clean() => _scene.Destroy();

        [Test]
        public void Place_PoseInTheWorld_SetsTheTransform()
        {
            _anchor.Place(new Vector3(1, 2, 3), Quaternion.Euler(0, 90, 0));

            Assert.That(Vector3.Distance(_anchor.transform.position, new Vector3(1, 2, 3)), Is.LessThan(1e-6));
            Assert.That(Vector3.Distance(_anchor.transform.TransformPoint(Vector3.forward), new Vector3(2, 2, 3)), Is.LessThan(1e-6));
            Assert.That(_moves, Is.EqualTo(1));
        }

        [Test]
        public void Place_RotationNotNormalised_IsNormalised()
        {
            _anchor.Place(Vector3.zero, new Quaternion(0, 2, 0, 2));

            Assert.That(Quaternion.Angle(_anchor.transform.rotation, Quaternion.Euler(0, 90, 0)), Is.LessThan(0.05));
            Assert.That(Quaternion.Dot(_anchor.transform.rotation, _anchor.transform.rotation), Is.EqualTo(1).Within(1e-6));
        }

        [Test]
        public void Nudge_RotatedAnchor_MovesAlongTheAnchorsAxes()
        {
            _anchor.Place(new Vector3(1, 0, 0), Quaternion.Euler(0, 90, 0));

            _anchor.Nudge(new Vector3(0, 0.01f, 0.05f), 30);

            // The anchor's forward axis is the world's right axis.
            Assert.That(Vector3.Distance(_anchor.transform.position, new Vector3(1.05f, 0.01f, 0)), Is.LessThan(1e-6));
            Assert.That(Quaternion.Angle(_anchor.transform.rotation, Quaternion.Euler(0, 120, 0)), Is.LessThan(0.05));
            Assert.That(_moves, Is.EqualTo(2));
        }

        [Test]
        public void Nudge_LockedBase_StaysLockedAtTheNewPose()
        {
            _anchor.Use("", Array.Empty<BaseMarker>());
            var (now, pose) = (HeadsetTime.FromSeconds(1), UnityPoses.ToRoom(new Vector3(1, 0, 0), Quaternion.identity));
            _anchor.Tracker.Tick(now, new[] { new MarkerSighting("hand", null, pose, 0, now, MarkerTracking.Placed) }, null, null);
            _anchor.Tracker.Tick(now, Array.Empty<MarkerSighting>(), null, null);
            Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
            _anchor.transform.SetPositionAndRotation(new Vector3(1, 0, 0), Quaternion.identity);

            _anchor.Nudge(new Vector3(0, 0.01f, 0), 0);

            Assert.That(_anchor.State, Is.EqualTo(BaseAnchorState.Locked));
            Assert.That(Vector3.Distance(UnityPoses.ToWorld(_anchor.Tracker.Shown.Value).position, new Vector3(1, 0.01f, 0)), Is.LessThan(1e-6));
            Assert.That(_moves, Is.EqualTo(1));
        }

        [Test]
        public void Place_InvalidPose_ThrowsWithoutMoving()
        {
            _anchor.Place(new Vector3(1, 2, 3), Quaternion.identity);

            Assert.Throws<ArgumentException>(() => _anchor.Place(new Vector3(float.NaN, 0, 0), Quaternion.identity));
            Assert.Throws<ArgumentException>(() => _anchor.Place(Vector3.zero, new Quaternion(0, 0, 0, 0)));
            Assert.Throws<ArgumentException>(() => _anchor.Place(Vector3.zero, new Quaternion(0, float.NaN, 0, 1)));
            Assert.Throws<ArgumentException>(() => _anchor.Nudge(Vector3.zero, float.PositiveInfinity));
            Assert.Throws<ArgumentException>(() => _anchor.Nudge(new Vector3(0, float.NegativeInfinity, 0), 0));

            Assert.That(Vector3.Distance(_anchor.transform.position, new Vector3(1, 2, 3)), Is.LessThan(1e-6));
            Assert.That(_moves, Is.EqualTo(1));
        }
    }
}
