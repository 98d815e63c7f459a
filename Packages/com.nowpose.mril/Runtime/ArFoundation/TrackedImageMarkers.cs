using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Unity.XR.CoreUtils;
using UnityEngine;
using UnityEngine.XR.ARFoundation;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Provides AR Foundation's tracked images as markers. The payload of a marker is the image's name in its library.</summary>
    /// <remarks>
    /// AR Foundation does not report when an image was last seen. This class uses the last time at which the pose of the image changed
    /// while the image was tracked. Before the first such change, it uses the time at which the device first listed the image.
    /// </remarks>
    [AddComponentMenu("Nowpose/Tracked Images")]
    [DisallowMultipleComponent]
    public sealed class TrackedImageMarkers : MonoBehaviour, IMarkerSource, IMarkerProblem
    {
        /// <summary>
        /// Pose of the marker frame in AR Foundation's image frame. The image frame has x to the right, z to the upper edge and y out of
        /// the print. In URDF axes, the pose is a quarter turn about the normal.
        /// </summary>
        static readonly RigidTransform MarkerInImage = RigidTransform.FromXyzRpy(0, 0, 0, 0, 0, -Math.PI / 2);

        [SerializeField, Tooltip("The session whose clock determines when an image was seen. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The XR Origin with the AR Tracked Image Manager. Empty: the XR Origin above the main camera.")]
        XROrigin _origin = null;

        readonly OriginManager<ARTrackedImageManager> _images = new OriginManager<ARTrackedImageManager>(
            manager => manager.subsystem, isAdded: false, DeviceMessages.ImageNeeds);

        readonly MarkerRecords _records = new MarkerRecords();
        MrilSession _source;

        /// <summary>Reason why no images are tracked, in one line; null if no problem is known.</summary>
        public string Problem => _images.Problem;

        public void Read(List<MarkerSighting> markers)
        {
            if (!isActiveAndEnabled || !_images.IsRunning) return;
            var now = _source.ClockOrDevices().Now;
            _records.Begin();
            foreach (var image in _images.Manager.trackables)
                if (image != null) markers.Add(SightingOf(image, _records.Of(image.trackableId), now));
            _records.End();
        }

        void OnEnable() => _source = this.SessionOfSource(_session, "tracked images");

        void OnDisable() => _records.Clear();

        void Update()
        {
            if (_images.Follow(_origin) && Problem != null) ConsoleLog.Warn(this, ComponentMessages.Of("tracked images", name, Problem));
        }

        MarkerSighting SightingOf(ARTrackedImage image, MarkerRecord record, HeadsetTime now)
        {
            var place = image.transform;
            var pose = new Pose(place.position, place.rotation);
            // A camera never measures exactly the same pose twice, so an unchanged pose is an old measurement.
            var isSeen = image.trackingState == TrackingState.Tracking && !(record.SeenAt is Pose before && before.Equals(pose));
            if (isSeen || record.LastSeen == null) (record.LastSeen, record.SeenAt) = (now, pose);
            record.Payload = image.referenceImage.name;
            return new MarkerSighting(
                record.Id, record.Payload, UnityPoses.ToRoom(place.position, place.rotation) * MarkerInImage, image.size.x, record.LastSeen.Value,
                _images.IsSessionOrigin(place.position) ? MarkerTracking.None : image.trackingState.OfMarker());
        }
    }
}
