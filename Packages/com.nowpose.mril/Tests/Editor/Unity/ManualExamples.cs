using System.Collections.Generic;
using System.IO;
using Nowpose.Anchoring;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Compiles the code of the manual's pages. A test of the repository checks that the pages contain the same code.</summary>
    static class ManualExamples
    {
        internal static void Follow(MrilSession session, RobotRig rig, GameObject warning, Transform lamp)
        {
            session.Changed += change => { if ((change & SessionChange.Lost) != 0) warning.SetActive(true); };
            session.Changed += change => { if ((change & SessionChange.Synchronised) != 0) warning.SetActive(false); };
            rig.Posed += () => lamp.position = rig.Tool.position;
        }

        internal static void Connect(MrilSession session, ConnectionSettings connection)
        {
            session.Settings = new SessionSettings(connection, VisualisationLatency.FromMilliseconds(43), rewriteBeforeRender: true);
            session.Connect();
        }

        internal static void ConnectWithToken(MrilSession session, SessionSettingsAsset settings, string token)
        {
            session.Settings = settings.ToSettings(token);
            session.Connect();
        }

        internal static void LogJointsWithoutData(MrilSession session)
        {
            foreach (var joint in session.Statistics.JointStatuses)
                if (joint.IsMissing) Debug.Log(joint.Joint + ": " + joint.Description);
        }

        internal static void Place(BaseAnchor anchor, Pose pose)
        {
            anchor.Place(pose.position, pose.rotation);
            anchor.Nudge(new Vector3(0.005f, 0, 0), degreesAboutUp: 0.5f);
        }

        internal static void AddARobot(BaseAnchor anchor, RobotDescriptionAsset description)
        {
            var made = new GameObject("Second");
            made.transform.SetParent(anchor.transform, worldPositionStays: false);
            var second = made.AddComponent<RobotRig>();
            made.AddComponent<PoseAppearance>();
            second.Follow(null, "arm2", description);
        }

        internal static void AddAnObject(GameObject model, BaseAnchor anchor, MrilSession session)
        {
            var made = Object.Instantiate(model, anchor.transform);
            made.AddComponent<TrackedObject>().Follow(session, "workpiece_7");
            made.SetActive(true);
        }

        internal static void MoveWithoutASession(RobotRig rig, RobotDescriptionAsset asset)
        {
            rig.Bind(asset.Read());
            var joints = new double[rig.Model.MovingJoints.Count];
            joints[rig.Model.IndexOfMovingJoint("arm_joint_2")] = 1.2;
            rig.Apply(joints);
        }

        public sealed class GatewayFile : MonoBehaviour
        {
            [SerializeField] MrilSession _session = null;
            [SerializeField] SessionSettingsAsset _settings = null;

            void Awake()
            {
                var path = Path.Combine(Application.persistentDataPath, "gateway.txt");
                if (!File.Exists(path)) return;
                var lines = File.ReadAllLines(path);
                var asset = _settings.ToSettings(lines.Length > 2 ? lines[2] : null);
                var connection = asset.Connection;
                _session.Settings = asset.With(new ConnectionSettings(
                    lines[0], connection.SyncPort, connection.WebSocketPort, CertificatePin.Parse(lines[1]), token: connection.Token,
                    headsetName: connection.HeadsetName, publishesDisplayed: connection.PublishesDisplayed, clockSource: connection.ClockSource));
            }
        }

        public sealed class MyMarkers : MonoBehaviour, IMarkerSource
        {
            [SerializeField] MrilSession _session = null;

            MarkerSighting? _seen;

            // Call this method when the SDK has measured the pose of the code. The z axis points right along the print, the x axis to its lower edge,
            // and the y axis out of it.
            public void Seen(Pose pose)
            {
                var place = UnityPoses.ToRoom(pose.position, pose.rotation);
                _seen = new MarkerSighting("1", "my robot", place, 0.12, _session.HeadsetClock.Now, MarkerTracking.Tracking);
            }

            public void Read(List<MarkerSighting> markers)
            {
                if (_seen is MarkerSighting seen) markers.Add(seen);
            }
        }
    }
}
