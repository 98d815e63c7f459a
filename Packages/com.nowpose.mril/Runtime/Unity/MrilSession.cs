using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity
{
    /// <summary>
    /// Runs a session while this component is enabled: connects to the gateway, and predicts in each frame where the robot is at the frame's
    /// display time.
    /// </summary>
    /// <remarks>
    /// The component computes the pose late in LateUpdate, after most other scripts. Components that show the robot listen to
    /// <see cref="Shown"/>. The session ends when the application is paused, or loses the focus without running in the background. When the
    /// application continues, a new session starts and synchronises its clock again, so old data cannot look current.
    /// </remarks>
    [AddComponentMenu("Nowpose/Session")]
    [DefaultExecutionOrder(ExecutionOrder)]
    [DisallowMultipleComponent]
    public sealed class MrilSession : MonoBehaviour
    {
        /// <summary>Execution order of this component. It runs after scripts with the default order 0.</summary>
        public const int ExecutionOrder = 10_000;

        [SerializeField, Tooltip("Address of the gateway and calibration of the display.")]
        SessionSettingsAsset _settings = null;

        [SerializeField, Tooltip("The robot. Empty: the robot that the gateway describes on /robot_description.")]
        RobotDescriptionAsset _robot = null;

        [SerializeField, Tooltip("Connect when this component is enabled. Turn off if a menu calls Connect or a script provides the samples.")]
        bool _connectOnEnable = true;

        [SerializeField, Tooltip("Called when the clock has been synchronised for half a second.")]
        UnityEvent _onSynchronised = new UnityEvent();

        [SerializeField, Tooltip("Called when the clock is no longer synchronised or the application was paused; not called when this component "
            + "is disabled.")]
        UnityEvent _onLost = new UnityEvent();

        [SerializeField, Tooltip("Called when the render time has been in the constant-latency range for half a second; without a calibrated range, "
            + "when frames no longer miss refreshes.")]
        UnityEvent _onEnteredRange = new UnityEvent();

        [SerializeField, Tooltip("Called when the render time has left the constant-latency range, or frames miss refreshes: the "
            + "visualisation latency is longer than calibrated.")]
        UnityEvent _onLeftRange = new UnityEvent();

        [SerializeField, Tooltip("Called when the arm is held, because its samples are too old or too few.")]
        UnityEvent _onStale = new UnityEvent();

        readonly SessionWatch _watch = new SessionWatch();
        readonly FrameStatistics _statistics = new FrameStatistics();

        /// <summary>The objects and signals of the cell that components show in this session, and the robots that rigs show.</summary>
        internal readonly ShownParts Parts = new ShownParts();
        internal readonly RigRobots Robots = new RigRobots();
        readonly DeviceWatch _device = new DeviceWatch();
        readonly KeptDisplay _display = new KeptDisplay();
        readonly Listeners<Action<DisplayFrame>> _computed = new Listeners<Action<DisplayFrame>>(), _shown = new Listeners<Action<DisplayFrame>>();
        readonly Listeners<Action> _hidden = new Listeners<Action>(), _robotChanged = new Listeners<Action>();
        readonly Listeners<Action<SessionChange>> _changed = new Listeners<Action<SessionChange>>();
        SessionChangeQueue _changes;
        BeforeRender _beforeRender;
        SessionLog _log;
        SessionSettings _given, _used;
        IHeadsetClock _clock, _nextClock = new StopwatchHeadsetClock();
        ApplicationPresence _presence;
        DescriptionWatch _description;
        StartProblem _problem;
        bool _isRunning, _isWanted;

        /// <summary>Raised after the pose is computed: once per frame, and again right before rendering if the settings request it.</summary>
        /// <remarks>Not raised while the robot is unknown. The session reuses the frame object, so listeners must not store it.</remarks>
        public event Action<DisplayFrame> Shown { add => _shown.Add(value); remove => _shown.Remove(value); }

        /// <summary>Raised before <see cref="Shown"/>, and also while the robot is unknown, for objects and signals of the cell.</summary>
        internal event Action<DisplayFrame> Computed { add => _computed.Add(value); remove => _computed.Remove(value); }

        /// <summary>Raised when the session is paused, disabled or restarted: the displayed pose is then not current.</summary>
        public event Action Hidden { add => _hidden.Add(value); remove => _hidden.Remove(value); }

        /// <summary>Raised when <see cref="Robot"/> changes.</summary>
        public event Action RobotChanged { add => _robotChanged.Add(value); remove => _robotChanged.Remove(value); }

        /// <summary>Raised for each change of the session. If there is a UnityEvent for the change, the UnityEvent is raised first.</summary>
        public event Action<SessionChange> Changed { add => _changed.Add(value); remove => _changed.Remove(value); }

        /// <summary>The running session, a new one after each pause; null while the component is disabled or paused, or its settings are invalid.</summary>
        public CompensationSession Session { get; private set; }

        /// <summary>The robot of the newest session, from the asset or as described by the gateway; null while it is unknown.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>The components that move objects of the scene before <see cref="Shown"/> is raised.</summary>
        internal Movers Movers { get; } = new Movers();

        /// <summary>The last computed frame; null without a session or while the robot is unknown.</summary>
        public DisplayFrame Frame { get; private set; }

        /// <summary>Reason why this component, although enabled, could not start a session, in one line; null if no problem is known.</summary>
        public string Problem => _problem.Text;

        /// <summary>Statistics of the session in this frame; null without a session. Later frames reuse the object.</summary>
        public SessionStatistics Statistics => Session == null ? null : _statistics.Of(Session, _clock);

        /// <summary>Settings of the session, which a new value restarts. The default, which null restores, is the settings asset.</summary>
        public SessionSettings Settings
        {
            get => _given ?? _used;
            set { _given = value; Restart(); }
        }

        /// <summary>Description of the robot; null to use the description from the gateway. Setting this property restarts the session.</summary>
        public RobotDescriptionAsset RobotAsset
        {
            get => _robot;
            set { (_robot, _description) = (value, default); Restart(); }
        }

        /// <summary>Headset clock. A new value takes effect in the next session. The default is a stopwatch.</summary>
        public IHeadsetClock HeadsetClock { get => _nextClock; set => _nextClock = value ?? throw new ArgumentNullException(nameof(value)); }

        /// <summary>Whether a connection is requested: from <see cref="Connect"/> until <see cref="Disconnect"/>.</summary>
        public bool IsConnecting => _isWanted;

        /// <summary>Source of the display time of each frame in this session and all later ones; null to use the calibrated L_visu.</summary>
        public IDisplayTimeSource DisplayTimeSource { get => _display.TimeSource; set => _display.TimeSource = value; }

        /// <summary>Reprojection mode of the display in this session and all later ones, set by components that control or observe the display.</summary>
        public ReprojectionMode Reprojection { get => _display.Reprojection; set => _display.Reprojection = value; }

        /// <summary>Whether the application submits its depth buffer in this session and all later ones, set by a component that observes it.</summary>
        public DepthSubmission DepthSubmission { get => _display.DepthSubmission; set => _display.DepthSubmission = value; }

        /// <summary>Whether the pose is now computed again in the frame, right before rendering, when the display time is known better.</summary>
        public bool IsBeforeRender => _beforeRender != null && _beforeRender.IsNow;

        /// <summary>Returns the state that the look of <see cref="Robot"/> shows in a frame.</summary>
        internal PoseState StateIn(DisplayFrame frame) => Robot == null ? PoseState.Incomplete : frame.SettledState;

        /// <summary>Starts to connect to the gateway and returns without delay. Connects again after each pause and after a loss of the connection.</summary>
        public void Connect()
        {
            _isWanted = true;
            Session?.Connect();
        }

        /// <summary>Disconnects from the gateway. The robot holds its last pose and is shown as not current.</summary>
        public void Disconnect()
        {
            _isWanted = false;
            Session?.Disconnect();
        }

        void OnEnable()
        {
            _log ??= new SessionLog(this);
            _changes ??= new SessionChangeQueue(Raise);
            _beforeRender ??= new BeforeRender(this, ShowAgain);
            _isRunning = true;
            _isWanted |= _connectOnEnable;
            // A disabled component does not receive Unity's messages about pause and focus, so the stored state may be out of date.
            _presence = default;
            _beforeRender.Begin();
            Begin();
        }

        void OnDisable()
        {
            _isRunning = false;
            _beforeRender.End();
            _watch.End();
            _problem = default;
            End();
        }

        void OnApplicationPause(bool isPaused) => Follow(_presence.Paused(isPaused));

        void OnApplicationFocus(bool hasFocus) => Follow(_presence.Focused(hasFocus));

        void LateUpdate()
        {
            if (_problem.IsDue) Begin();
            if (Session == null) return;
            _device.Follow(Session);
            if (_description.Follow(Session, Robot, _robot, _log)) Restart();
            var frame = Show(isLast: !_used.RewriteBeforeRender);
            if (frame == null) return;
            _log.Follow(Session);
            Notify(_watch.Changed(frame));
        }

        void ShowAgain()
        {
            if (Session != null && _used.RewriteBeforeRender) Show(isLast: true);
        }

        void Follow(ApplicationPresence presence)
        {
            _presence = presence;
            if (_presence.IsAway) Leave();
            else if (Problem == null) Begin();
        }

        /// <summary>Ends the session, and starts a new one with the present settings.</summary>
        internal void Restart()
        {
            _problem = default;
            Leave();
            Begin();
        }

        // Listeners may disable this component or change its settings. Methods therefore raise events last, or check the state again afterwards.
        void Begin()
        {
            if (!_isRunning || _presence.IsAway || Session != null) return;
            RobotModel robot;
            try
            {
                _used = _given ?? (_settings != null ? _settings.ToSettings() : throw new InputException(ComponentMessages.NoSettings(name)));
                robot = _description.ModelOf(_robot, Robot, _used);
            }
            catch (InputException fault)
            {
                _problem.Report(fault.Message, _log);
                return;
            }
            _problem = default;
            _clock = _nextClock;
            Session = new CompensationSession(_used, robot ?? DescriptionWatch.NoRobot, _clock, Transport.Create);
            _display.Follow(Session);
            _device.Begin(Session);
            if (_isWanted) Session.Connect();
            if (robot == Robot) return;
            Robot = robot;
            _robotChanged.Raise(this);
        }

        void Leave()
        {
            End();
            Notify(_watch.End());
        }

        void End()
        {
            if (Session == null) return;
            Session.Dispose();
            Session = null;
            Movers.Stop();
            _display.Follow(null);
            Frame = null;
            _hidden.Raise(this);
        }

        void Notify(SessionChange change)
        {
            if (change == SessionChange.None) return;
            _log.Log(change, Session, Statistics);
            _changes.Add(change);
        }

        void Raise(SessionChange change)
        {
            if ((change & SessionChange.Synchronised) != 0) _onSynchronised.Raise(this);
            if ((change & SessionChange.Lost) != 0) _onLost.Raise(this);
            if ((change & SessionChange.EnteredRange) != 0) _onEnteredRange.Raise(this);
            if ((change & SessionChange.LeftRange) != 0) _onLeftRange.Raise(this);
            if ((change & SessionChange.Stale) != 0) _onStale.Raise(this);
            _changed.Raise(this, change);
        }

        /// <returns>Null if a listener ended the session.</returns>
        DisplayFrame Show(bool isLast)
        {
            if (Session == null) return null;
            var session = Session;
            var frame = session.Tick(_clock.Now, isLast);
            // A listener of a signal may have ended the session.
            if (Session != session) return null;
            _statistics.Expire();
            if (Robot != null) Frame = frame;
            // A listener of a rig may end the session, too.
            Movers.Move(frame);
            if (Session != session) return null;
            _computed.Raise(this, frame);
            if (Session != session) return null;
            if (Robot != null) _shown.Raise(this, frame);
            return Session == session ? frame : null;
        }
    }
}
