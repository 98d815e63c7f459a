using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    public class HandPlacedMarkerTests
    {
        readonly SceneObjects _scene = new SceneObjects();
        HandPlacedMarker _marker;

        [SetUp]
        public void MakeMarker() => _marker = _scene.New<HandPlacedMarker>("Marker", null);

        [TearDown]
        public void Clean() => _scene.Destroy();

        List<MarkerSighting> Read()
        {
            var markers = new List<MarkerSighting>();
            _marker.Read(markers);
            return markers;
        }

        [Test]
        public void Read_NeverMoved_ReturnsNoMarker()
        {
            Assert.That(Read(), Is.Empty);
        }

        [Test]
        public void Read_AfterRelease_ReturnsPoseAndTimeOfTheRelease()
        {
            _marker.transform.position = new Vector3(1, 2, 3);
            _marker.BeginMove();
            Assert.That(_marker.IsMoving, Is.True);
            _marker.EndMove();

            var first = Read()[0];
            var second = Read()[0];

            Assert.That(_marker.IsMoving, Is.False);
            Assert.That(first.Tracking, Is.EqualTo(MarkerTracking.Placed));
            Assert.That(first.KeepsUpright, Is.True, "the default");
            Assert.That(first.Payload, Is.Null, "the marker represents the base frame itself");
            Assert.That(new[] { first.Pose.X, first.Pose.Y, first.Pose.Z }, Is.EqualTo(new double[] { 3, -1, 2 }), "in the axes of the URDF");
            Assert.That(second.LastSeen, Is.EqualTo(first.LastSeen), "the marker has not moved since then");
        }

        [Test]
        public void Read_WhileMoving_ReturnsANewTimeEachFrame()
        {
            _marker.BeginMove();

            var first = Read()[0].LastSeen;

            Assert.That(Read()[0].LastSeen, Is.GreaterThan(first));
        }
    }
}
