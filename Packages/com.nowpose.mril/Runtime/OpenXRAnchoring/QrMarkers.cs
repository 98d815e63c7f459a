using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.ArFoundation;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using Unity.XR.CoreUtils;
using UnityEngine;
// These aliases are needed because AR Foundation has types with the same names since version 6.4.
using ARMarker = Microsoft.MixedReality.OpenXR.ARMarker;
using ARMarkerManager = Microsoft.MixedReality.OpenXR.ARMarkerManager;
using ARMarkerType = Microsoft.MixedReality.OpenXR.ARMarkerType;
using TransformMode = Microsoft.MixedReality.OpenXR.TransformMode;

namespace Nowpose.OpenXR
{
    /// <summary>
    /// Provides the QR codes that a HoloLens 2 detects as markers. Needs Microsoft's Mixed Reality OpenXR plugin and the app's capability WebCam.
    /// </summary>
    /// <remarks>
    /// The plugin reports the pose of a code at its upper left corner, with x to the right, y down and z out of the print. In the mode
    /// <see cref="TransformMode.Center"/>, the plugin shifts this pose by half the size along the axes of the room. This is correct only for an
    /// upright code that faces one of these axes. This component therefore reads the corner and shifts along the axes of the code.
    /// </remarks>
    [AddComponentMenu("Nowpose/QR Markers")]
    [DisallowMultipleComponent]
    public sealed class QrMarkers : MonoBehaviour, IMarkerSource, IMarkerProblem
    {
        /// <summary>Pose of the marker frame relative to the code frame that the plugin reports, in URDF axes.</summary>
        static readonly RigidTransform MarkerInCode = RigidTransform.FromXyzRpy(0, 0, 0, -Math.PI / 2, 0, -Math.PI / 2);

        [SerializeField, Tooltip("The session whose clock determines when a code was seen. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The XR Origin. The component adds an AR Marker Manager if it has none. Empty: the XR Origin above the main "
            + "camera.")]
        XROrigin _origin = null;

        readonly OriginManager<ARMarkerManager> _codes = new OriginManager<ARMarkerManager>(
            manager => manager.subsystem, isAdded: true,
            DeviceMessages.QrCodeNeeds);

        readonly MarkerRecords _records = new MarkerRecords();
        MrilSession _source;
        ARMarkerManager _setUp;

        /// <summary>Reason why no codes are found, in one line; null if no problem is known.</summary>
        public string Problem => _codes.Problem;

        public void Read(List<MarkerSighting> markers)
        {
            if (!isActiveAndEnabled || !_codes.IsRunning) return;
            var now = _source.ClockOrDevices().Now;
            var seconds = Time.realtimeSinceStartup;
            _records.Begin();
            foreach (var code in _codes.Manager.trackables)
                if (code != null && code.markerType == ARMarkerType.QRCode) markers.Add(SightingOf(code, _records.Of(code.trackableId), now, seconds));
            _records.End();
        }

        void OnEnable() => _source = this.SessionOfSource(_session, "QR markers");

        void OnDisable()
        {
            _records.Clear();
            if (!_codes.Remove()) return;
            foreach (var code in _codes.Manager.trackables)
                if (code != null) Destroy(code.gameObject);
        }

        void Update()
        {
            if (_codes.Follow(_origin) && Problem != null) ConsoleLog.Warn(this, ComponentMessages.Of("QR markers", name, Problem));
            if (_codes.Manager != null && _codes.Manager != _setUp) SetUp(_codes.Manager);
        }

        void SetUp(ARMarkerManager manager)
        {
            _setUp = manager;
            if (manager.defaultTransformMode != TransformMode.MostStable)
                ConsoleLog.Warn(this, DeviceMessages.MarkerMode(name, manager.defaultTransformMode.ToString(), TransformMode.MostStable.ToString()));
            manager.defaultTransformMode = TransformMode.MostStable;
            if (Array.IndexOf(manager.enabledMarkerTypes, ARMarkerType.QRCode) >= 0) return;
            var types = manager.enabledMarkerTypes;
            Array.Resize(ref types, types.Length + 1);
            types[types.Length - 1] = ARMarkerType.QRCode;
            manager.enabledMarkerTypes = types;
        }

        MarkerSighting SightingOf(ARMarker code, MarkerRecord record, HeadsetTime now, float seconds)
        {
            Follow(code, record, now, seconds);
            var corner = code.transform;
            var rotation = corner.rotation;
            var shift = rotation * new Vector3(code.center.x, code.center.y, 0);
            var isCentre = code.transformMode == TransformMode.Center;
            // The plugin reports an unknown pose as the session's origin. It must be recognised before the shift to the centre, which moves it away
            // from the origin. In the mode Center, the plugin has already shifted the pose. An unknown pose has no rotation, so subtracting the same
            // shift gives the origin again.
            var isNowhere = _codes.IsSessionOrigin(corner.position) || (isCentre && _codes.IsSessionOrigin(corner.position - shift));
            var centre = isCentre ? corner.position : corner.position + shift;
            return new MarkerSighting(
                record.Id, record.Payload, UnityPoses.ToRoom(centre, rotation) * MarkerInCode, code.size.x, record.LastSeen ?? now,
                isNowhere ? MarkerTracking.None : code.trackingState.OfMarker());
        }

        // Converts the time of a sighting only once. A conversion in each frame would give the same sighting a different time each time.
        static void Follow(ARMarker code, MarkerRecord record, HeadsetTime now, float seconds)
        {
            if (code.lastSeenTime == record.LastSeenSeconds) return;
            record.LastSeenSeconds = code.lastSeenTime;
            var ago = (double)seconds - code.lastSeenTime;
            // After days of operation, the plugin's time (a float in seconds) is coarser than a frame, so the age may become negative.
            record.LastSeen = now - new TimeSpan((long)(Math.Max(0, ago) * TimeSpan.TicksPerSecond));
            if (string.IsNullOrEmpty(record.Payload)) record.Payload = Text(code.GetDecodedString());
        }

        // The plugin returns an empty string for a code that it has found but not yet decoded.
        static string Text(string decoded) => string.IsNullOrEmpty(decoded) ? null : decoded;
    }
}
