using System;
using System.Globalization;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Records the received data, the displayed poses and the statistics of a session in a file on the device, for later analysis.
    /// </summary>
    /// <remarks>
    /// Each session has its own file; a new session starts after a pause and when the gateway describes another robot. Frames never wait for the
    /// disk. Only the frame that starts a file allocates.
    /// </remarks>
    [AddComponentMenu("Nowpose/Session Recording")]
    [DisallowMultipleComponent]
    public sealed class SessionRecording : MonoBehaviour
    {
        [SerializeField, Tooltip("The session to record. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Folder for the files: a path below the application's persistent data path, or a full path. It is created if it "
            + "does not exist. A HoloLens shows the persistent data path as LocalState in its device portal.")]
        string _folder = "recordings";

        [SerializeField, Tooltip("Maximum size of one file in megabytes, 0.001 to 100000. At this size the recording ends with a message. 500 MB "
            + "hold five hours of a typical session.")]
        double _maximumMegabytes = 500;

        [SerializeField, Tooltip("Record when this component is enabled. Turn off if a menu calls StartRecording.")]
        bool _recordOnEnable = true;

        MrilSession _source;
        CompensationSession _recorded;
        bool _isWanted;

        /// <summary>Whether a file is being written; false while the session is paused or its robot is unknown.</summary>
        public bool IsRecording => Recorder != null && Recorder.State == RecordingState.Recording;

        /// <summary>Path of the current or last file; null before the first file.</summary>
        [field: NonSerialized] public string Path { get; private set; }

        /// <summary>Reason why a requested recording is not running, in one line; null if no problem is known.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>Starts to record the current session and all later sessions. Call it again to retry after a problem.</summary>
        public void StartRecording()
        {
            if (IsRecording) return;
            End();
            Problem = null;
            _isWanted = true;
            Follow();
        }

        /// <summary>Stops recording. Returns without delay; the rest of the file is written in the background.</summary>
        public void StopRecording()
        {
            _isWanted = false;
            End();
        }

        // OnDisable disposes the recorder. Unity always calls it before a component is destroyed.
        SessionRecorder Recorder { get; set; }

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "session recording");
            // During a pause, the system may end the application, and no further frame follows.
            if (_source != null) _source.Hidden += Follow;
            if (_recordOnEnable) StartRecording();
        }

        void OnDisable()
        {
            if (_source is object) _source.Hidden -= Follow;
            StopRecording();
        }

        // Runs before the session computes its frame, so the file contains the first frame of the session.
        void Update()
        {
            Follow();
            Report();
        }

        void Follow()
        {
            var session = _isWanted && isActiveAndEnabled && _source != null ? _source.Session : null;
            if (session != null && !HasContent(session)) session = null;
            if (session == _recorded) return;
            End();
            if (session != null) Begin(session);
        }

        // Until the gateway has described the session's own robot, only objects and further robots can be recorded. The description starts a new session
        // and therefore a new file.
        static bool HasContent(CompensationSession session) =>
            session.Robot.MovingJoints.Count > 0 || session.Robots.Count > 1 || session.Frames.Tree.Count > 0;

        void Begin(CompensationSession session)
        {
            _recorded = session;
            Problem = null;
            var now = DateTime.UtcNow;
            try
            {
                Path = System.IO.Path.Combine(
                    Application.persistentDataPath, _folder, now.ToString("'nowpose-'yyyyMMdd'T'HHmmssfff'Z.jsonl'", CultureInfo.InvariantCulture));
                Recorder = new SessionRecorder(session, new RecordingSettings(Path, _maximumMegabytes, now));
            }
            catch (Exception fault) when (fault is InputException || fault is ArgumentException)
            {
                Fail(ComponentMessages.Of("session recording", name, fault.Message));
                return;
            }
            ConsoleLog.Info(this, SessionMessages.Recording(Path));
        }

        void Report()
        {
            if (Recorder == null || IsRecording) return;
            Fail(Recorder.Problem);
            Recorder.Dispose();
            Recorder = null;
        }

        void Fail(string problem)
        {
            Problem = problem;
            ConsoleLog.Warn(this, problem);
        }

        void End()
        {
            Recorder?.Dispose();
            Recorder = null;
            _recorded = null;
        }
    }
}
