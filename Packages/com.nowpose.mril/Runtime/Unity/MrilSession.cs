using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity
{
    /// <summary>
    /// Runs a session while it is enabled: connects to the gateway, and once a frame computes where the robot is when the
    /// frame's light appears.
    /// </summary>
    /// <remarks>
    /// Runs late in LateUpdate, so that what a frame displays is computed as late as sensible and after users' scripts.
    /// Whatever shows the robot follows <see cref="Shown"/>. While the application is paused, or has lost the focus and does
    /// not run in the background, there is no session; afterwards a new one synchronises anew, so that nothing from before
    /// can look current.
    /// </remarks>
    [AddComponentMenu("Nowpose/Session")]
    [DefaultExecutionOrder(ExecutionOrder)]
    [DisallowMultipleComponent]
    public sealed class MrilSession : MonoBehaviour
    {
        /// <summary>Place of this component among all: after scripts that leave theirs at 0.</summary>
        public const int ExecutionOrder = 10_000;

        [SerializeField, Tooltip("Where the gateway is, and how the display is calibrated.")]
        SessionSettingsAsset _settings = null;

        [SerializeField, Tooltip("The robot. Empty: the one that the gateway describes on /robot_description.")]
        RobotDescriptionAsset _robot = null;

        [SerializeField, Tooltip("Connect as soon as this component is enabled. On, for most scenes have nothing to wait for; off where a menu "
            + "calls Connect, or where a script brings the samples.")]
        bool _connectOnEnable = true;

        [SerializeField, Tooltip("The clock has been synchronised for half a second.")]
        UnityEvent _onSynchronised = new UnityEvent();

        [SerializeField, Tooltip("The clock is synchronised no longer, or the application was paused; not called when this component is disabled.")]
        UnityEvent _onLost = new UnityEvent();

        [SerializeField, Tooltip("The render time has been in the constant-latency range for half a second.")]
        UnityEvent _onEnteredRange = new UnityEvent();

        [SerializeField, Tooltip("The render time is beyond the constant-latency range: the visualisation latency is longer than calibrated.")]
        UnityEvent _onLeftRange = new UnityEvent();

        [SerializeField, Tooltip("The arm is held, for its samples are too old or too few.")]
        UnityEvent _onStale = new UnityEvent();

        // What runs until the gateway has described a robot: it has no joints, and nothing shows it.
        static readonly RobotModel NoRobot = UrdfReader.Read("<robot name='none'><link name='base'/></robot>", "no robot");

        readonly SessionWatch _watch = new SessionWatch();
        readonly SessionStatistics _statistics = new SessionStatistics();
        readonly DeviceWatch _device = new DeviceWatch();
        // With room from the start: no frame allocates.
        readonly Queue<SessionChange> _changes = new Queue<SessionChange>(4);
        SessionLog _log;
        SessionSettings _given, _used;
        IHeadsetClock _nextClock = new StopwatchHeadsetClock();
        IHeadsetClock _clock;
        IDisplayTimeSource _displayTimes;
        ReprojectionMode _reprojection;
        DepthSubmission _depth;
        ApplicationPresence _presence;
        DescriptionWatch _description;
        bool _isRunning, _isWanted, _isFilled;

        /// <summary>
        /// The pose has been computed: once a frame, and a second time right before rendering where the settings ask for it. Not
        /// while the robot is unknown. The frame is the session's own: read it at once.
        /// </summary>
        public event Action<DisplayFrame> Shown;

        /// <summary>There is no frame any more (paused, disabled, another robot): what was shown last is not current.</summary>
        public event Action Hidden;

        /// <summary><see cref="Robot"/> is another one than before.</summary>
        public event Action RobotChanged;

        /// <summary>What the UnityEvents tell, for scripts.</summary>
        public event Action<SessionChange> Changed;

        /// <summary>Null while disabled, paused, or when the settings cannot be used. Another one after each pause.</summary>
        public CompensationSession Session { get; private set; }

        /// <summary>The asset's robot, or the one that the gateway described, as of the newest start; null before.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>What was computed last; null while there is no session or no robot.</summary>
        public DisplayFrame Frame { get; private set; }

        /// <summary>Why there is no session although this component is enabled, in one line; null when nothing is wrong.</summary>
        public string Problem { get; private set; }

        /// <summary>How the session does, as of this frame; null while there is none. One object, filled anew when asked in a later frame.</summary>
        public SessionStatistics Statistics
        {
            get
            {
                if (Session == null) return null;
                if (!_isFilled) Session.Fill(_statistics, _clock.Now);
                _isFilled = true;
                return _statistics;
            }
        }

        /// <summary>What the session runs with: the asset's, unless set. Setting it starts the session anew; null goes back to the asset.</summary>
        public SessionSettings Settings
        {
            get => _given ?? _used;
            set
            {
                _given = value;
                Restart();
            }
        }

        /// <summary>Describes the robot; null to take the gateway's. Setting it starts the session anew.</summary>
        public RobotDescriptionAsset RobotAsset
        {
            get => _robot;
            set
            {
                _robot = value;
                _description = default;
                Restart();
            }
        }

        /// <summary>The headset clock of sessions that begin from now on; a stopwatch unless set.</summary>
        public IHeadsetClock HeadsetClock
        {
            get => _nextClock;
            set => _nextClock = value ?? throw new ArgumentNullException(nameof(value));
        }

        /// <summary>Whether it is to be connected: since <see cref="Connect"/>, until <see cref="Disconnect"/>.</summary>
        public bool IsConnecting => _isWanted;

        /// <summary>
        /// Tells when light appears, frame by frame, and is believed before the calibrated L_visu; null for none. Set once, it serves every
        /// session from now on.
        /// </summary>
        public IDisplayTimeSource DisplayTimeSource
        {
            get => _displayTimes;
            set
            {
                _displayTimes = value;
                if (Session != null) Session.DisplayTimeSource = value;
            }
        }

        /// <summary>
        /// How the display corrects frames for head motion. Set by components that control or observe the display; kept for every later session.
        /// </summary>
        public ReprojectionMode Reprojection
        {
            get => _reprojection;
            set
            {
                _reprojection = value;
                if (Session != null) Session.Reprojection = value;
            }
        }

        /// <summary>Whether the depth buffer reaches the display. Set by a component that observes the display; kept for every later session.</summary>
        public DepthSubmission DepthSubmission
        {
            get => _depth;
            set
            {
                _depth = value;
                if (Session != null) Session.DepthSubmission = value;
            }
        }

        /// <summary>
        /// Whether the pose is being computed right before rendering, for the second time in its frame: a runtime knows the frame's display
        /// time better then.
        /// </summary>
        public bool IsBeforeRender { get; private set; }

        /// <summary>Connects to the gateway, now and after each pause. Returns at once; comes back by itself when the connection is lost.</summary>
        public void Connect()
        {
            _isWanted = true;
            Session?.Connect();
        }

        /// <summary>Leaves the gateway. The pose is held, and said to be.</summary>
        public void Disconnect()
        {
            _isWanted = false;
            Session?.Disconnect();
        }

        void OnEnable()
        {
            _log ??= new SessionLog(this);
            _isRunning = true;
            _isWanted |= _connectOnEnable;
            // Messages about pauses need not have reached it while it was disabled.
            _presence = default;
            Application.onBeforeRender += ShowAgain;
            Begin();
        }

        void OnDisable()
        {
            _isRunning = false;
            Application.onBeforeRender -= ShowAgain;
            _watch.End();
            Problem = null;
            End();
        }

        void OnApplicationPause(bool isPaused)
        {
            _presence.Paused(isPaused);
            FollowPresence();
        }

        void OnApplicationFocus(bool hasFocus)
        {
            _presence.Focused(hasFocus);
            FollowPresence();
        }

        void LateUpdate()
        {
            if (Session == null) return;
            _device.Follow(Session);
            if (_description.Follow(Session, Robot, _robot, _log)) Restart();
            var frame = Show(isLast: !_used.RewriteBeforeRender);
            if (frame == null) return;
            _log.Follow(Session);
            Tell(_watch.Changed(frame));
        }

        void ShowAgain()
        {
            if (Session == null || !_used.RewriteBeforeRender) return;
            IsBeforeRender = true;
            try
            {
                Show(isLast: true);
            }
            catch (Exception fault)
            {
                // The engine calls all that wait for this moment in one go: a listener's fault would cost the others their frame.
                Debug.LogException(fault, this);
            }
            finally
            {
                IsBeforeRender = false;
            }
        }

        void FollowPresence()
        {
            if (_presence.IsAway) Leave();
            else if (Problem == null) Begin();
        }

        void Restart()
        {
            Problem = null;
            Leave();
            Begin();
        }

        // Whoever hears an event may disable or destroy this, or give it other settings: so an event comes when all is as it
        // will stay, and what is done after it asks anew.
        void Begin()
        {
            if (!_isRunning || _presence.IsAway || Session != null) return;
            RobotModel robot;
            try
            {
                _used = _given ?? ReadSettings();
                robot = _robot != null ? ReadRobot() : _description.Robot;
            }
            catch (InputException fault)
            {
                Problem = fault.Message;
                _log.Fail(Problem);
                return;
            }
            Problem = null;
            _clock = _nextClock;
            Session = new CompensationSession(_used, robot ?? NoRobot, _clock, Transport.Create)
            {
                DisplayTimeSource = _displayTimes,
                Reprojection = _reprojection,
                DepthSubmission = _depth,
            };
            _device.Begin(Session);
            if (_isWanted) Session.Connect();
            if (robot == Robot) return;
            Robot = robot;
            RobotChanged?.Invoke();
        }

        void Leave()
        {
            End();
            Tell(_watch.End());
        }

        void End()
        {
            if (Session == null) return;
            Session.Dispose();
            Session = null;
            Frame = null;
            Hidden?.Invoke();
        }

        SessionSettings ReadSettings() => _settings != null
            ? _settings.ToSettings()
            : throw new InputException("session '" + name + "' has no settings; assign a Session Settings asset");

        // The same text is not read anew: rigs that are bound to its robot stay so.
        RobotModel ReadRobot() => Robot?.SourceHash == UrdfHash.Of(_robot.Urdf) ? Robot : _robot.Read();

        void Tell(SessionChange change)
        {
            if (change == SessionChange.None) return;
            _log.Say(change, Session, Statistics);
            _changes.Enqueue(change);
            // What a listener brings about is told once all have heard what it was told.
            if (_changes.Count > 1) return;
            try
            {
                for (; _changes.Count > 0; _changes.Dequeue()) Raise(_changes.Peek());
            }
            finally
            {
                _changes.Clear();
            }
        }

        void Raise(SessionChange change)
        {
            if ((change & SessionChange.Synchronised) != 0) _onSynchronised.Invoke();
            if ((change & SessionChange.Lost) != 0) _onLost.Invoke();
            if ((change & SessionChange.EnteredRange) != 0) _onEnteredRange.Invoke();
            if ((change & SessionChange.LeftRange) != 0) _onLeftRange.Invoke();
            if ((change & SessionChange.Stale) != 0) _onStale.Invoke();
            Changed?.Invoke(change);
        }

        /// <returns>Null when a listener ended the session.</returns>
        DisplayFrame Show(bool isLast)
        {
            if (Session == null) return null;
            var frame = Session.Tick(_clock.Now, isLast);
            _isFilled = false;
            if (Robot == null) return frame;
            Frame = frame;
            Shown?.Invoke(frame);
            return Frame;
        }
    }
}
