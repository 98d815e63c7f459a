using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>Headset runtime: synchronises the clock, measures the latency of samples, and shows the robot's pose at the display time.</summary>
    /// <remarks>
    /// The method of Schnierle &amp; Röck 2022. The same class runs in Unity, in the command line and in tests: <see cref="Tick"/> reads
    /// no clock and needs no network. Call <see cref="Tick"/>, <see cref="Connect"/>, <see cref="Disconnect"/> and
    /// <see cref="Dispose"/> on one thread, the frame's; all other members are thread-safe unless stated otherwise. The session never
    /// commands the robot.
    /// </remarks>
    public sealed class CompensationSession : IDisposable
    {
        readonly ClockSynchroniser _synchroniser;
        readonly DisplayClock _displayClock = new DisplayClock();
        readonly JointTracks _tracks;
        readonly DisplayFrame _frame;
        readonly JointWatch _joints;
        readonly CurrentShare _currentShare = new CurrentShare();
        readonly HindcastMonitor _hindcast;
        readonly SessionMeasurements _measurements;
        readonly ApplicationLatency _latency = new ApplicationLatency();
        readonly object _gate = new object();
        readonly SessionDisplay _display;
        readonly ReceivedDescription _description;
        readonly SessionConnections _connections;
        readonly DisplayedJoints _displayed;

        /// <param name="robot">Robot whose moving joints are matched with the names in the samples.</param>
        /// <param name="clock">Clock for time stamps of received messages.</param>
        public CompensationSession(SessionSettings settings, RobotModel robot, IHeadsetClock clock)
            : this(settings, robot, clock, WebSocketLinks.Create)
        {
        }

        /// <param name="newLink">Creates the WebSocket for each connection attempt.</param>
        internal CompensationSession(
            SessionSettings settings, RobotModel robot, IHeadsetClock clock, Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> newLink)
        {
            Settings = settings;
            Robot = robot;
            _description = new ReceivedDescription(robot);
            _display = new SessionDisplay(settings, _gate);
            _synchroniser = new ClockSynchroniser(settings.CreateClockEstimator(), settings.Clock);
            _tracks = new JointTracks(robot, settings.Prediction);
            _frame = new DisplayFrame(robot, _tracks, settings.OutsideRange);
            _displayed = new DisplayedJoints(robot, _frame, settings.Connection.HeadsetName);
            _joints = new JointWatch(robot, _tracks, settings.Prediction.HorizonCap);
            _hindcast = new HindcastMonitor(robot, settings.Prediction.MaximumGap);
            _tracks.Restarted += _hindcast.Restart;
            _measurements = new SessionMeasurements(_synchroniser, _latency, _display, _frame, _hindcast);
            Intake = new SessionIntake(robot, _tracks, _hindcast, _latency, settings.Prediction.FollowsPlans);
            Listener = new SessionListener(this, Intake, _joints, clock);
            _connections = new SessionConnections(settings, clock, newLink, Listener, _synchroniser, SyncFaults);
        }

        public RobotModel Robot { get; }

        /// <summary>Receives messages from the network or from a simulation. Thread-safe.</summary>
        internal IRosbridgeListener Listener { get; }

        /// <summary>Queues of messages for the next frame.</summary>
        internal SessionIntake Intake { get; }

        public SessionSettings Settings { get; }

        /// <summary>URDF text of the robot from the gateway, the newest valid one; null before. Thread-safe.</summary>
        public string RobotDescription => _description.Text;

        /// <summary>Robot model of <see cref="RobotDescription"/>; null before. Thread-safe.</summary>
        public RobotModel DescribedRobot => _description.Model;

        /// <summary>Whether <see cref="Robot"/> was read from the same text. Thread-safe.</summary>
        internal RobotDescriptionMatch RobotDescriptionMatch => _description.Match;

        /// <summary>Reason why the newest description could not be read, in one line; null without an error or description. Thread-safe.</summary>
        public string RobotDescriptionFault => _description.Fault;

        /// <summary>
        /// Joints with samples outside the robot's limits, which are therefore drawn in another position, in the order of detection, each
        /// once. On the thread of <see cref="Tick"/>.
        /// </summary>
        public IReadOnlyList<JointBeyondLimits> BeyondLimits => _tracks.Limits.Found;

        /// <summary>Clock synchroniser, fed by the network or a test. Frames follow it without going back in time.</summary>
        internal ClockSynchroniser Clock => _synchroniser;

        /// <summary>
        /// Raised when all samples are removed because the clock stepped or became known; within <see cref="Tick"/>, before new samples are
        /// processed.
        /// </summary>
        public event Action<HeadsetTime, ClockModel> Restarted;

        [Obsolete("use Restarted")]
        public event Action<HeadsetTime, ClockModel> StartedAnew
        {
            add => Restarted += value;
            remove => Restarted -= value;
        }

        /// <summary>Provides the computed frame; raised at the end of each <see cref="Tick"/>.</summary>
        /// <remarks>
        /// A handler must be fast, must not throw, and must not call methods of the session except <see cref="Fill"/>; it may read properties.
        /// </remarks>
        public event Action<DisplayFrame> Ticked;

        /// <summary>Forwards <see cref="HindcastMonitor.ToolJudged"/>; raised within <see cref="Tick"/>.</summary>
        internal event Action<ControlTime, PoseState, ErrorSample> ToolJudged
        {
            add => _hindcast.ToolJudged += value;
            remove => _hindcast.ToolJudged -= value;
        }

        /// <summary>Counts of dropped messages by reason.</summary>
        internal DropCounters Drops => Intake.Drops;

        /// <summary>Counts of dropped sync exchanges by reason.</summary>
        internal SyncFaultCounters SyncFaults { get; } = new SyncFaultCounters();

        /// <summary>Calibrated L_visu. May change while the session runs; setting it clears <see cref="Profile"/>.</summary>
        public VisualisationLatency Visualisation { get => _display.Visualisation; set => _display.Visualisation = value; }

        /// <summary>Profile of <see cref="Visualisation"/>; null when the value was set as a number. Thread-safe.</summary>
        public LatencyProfile Profile => _display.Profile;

        /// <summary>Range for render times: that of the profile, or else that of the settings; null when neither has one. Thread-safe.</summary>
        public ConstantLatencyRange Range => _display.Range;

        /// <summary>
        /// Source of display times, used instead of <see cref="Visualisation"/> while it provides one; null for none. Called within
        /// <see cref="Tick"/>; must not call the session. May be set on any thread.
        /// </summary>
        public IDisplayTimeSource DisplayTimeSource { get => _display.Source; set => _display.Source = value; }

        /// <summary>Whether the newest frame's display time comes from <see cref="DisplayTimeSource"/>, not the calibration. Thread-safe.</summary>
        public bool IsLightPredicted => _display.IsLightPredicted;

        /// <summary>
        /// Newest display time from <see cref="DisplayTimeSource"/> minus its frame's start, used or not; null without one. Thread-safe.
        /// </summary>
        public TimeSpan? DisplayTimeAhead => _display.Ahead;

        /// <summary>
        /// Reprojection mode of the display, as reported from outside; it does not change what a frame
        /// shows. Thread-safe.
        /// </summary>
        public ReprojectionMode Reprojection { get => _display.Reprojection; set => _display.Reprojection = value; }

        /// <summary>
        /// Conditions that affect L_visu. Set the conditions that the device reports; the value read also includes <see cref="Reprojection"/> and
        /// <see cref="SessionSettings.RewriteBeforeRender"/>. They do not change what a frame shows. Thread-safe.
        /// </summary>
        internal DisplayConditions Conditions { get => _display.Conditions; set => _display.Conditions = value; }

        /// <summary>Conditions that differ from those at the measurement of <see cref="Profile"/>; empty for none. Thread-safe.</summary>
        public IReadOnlyList<ConditionMismatch> ProfileMismatches => _display.ProfileMismatches;

        /// <summary>Whether the depth buffer reaches the display, as reported from outside. Thread-safe.</summary>
        public DepthSubmission DepthSubmission { get => _display.DepthSubmission; set => _display.DepthSubmission = value; }

        /// <summary>Δt_render of the newest call of <see cref="Rendered"/>; null when the render time is not measured.</summary>
        public TimeSpan? NewestRenderTime => _display.NewestRenderTime;

        /// <summary>Completes when the ended connections have released all resources, also sockets and threads; waiting is optional.</summary>
        public Task Ended => _connections.Ended;

        /// <summary>Status of the clock sync connection, or of the exchanges with ROS time. Thread-safe.</summary>
        public LinkStatus SyncLink => _connections.SyncLink;

        /// <summary>Status of the connection for joint positions. Thread-safe.</summary>
        public LinkStatus SampleLink => _connections.SampleLink;

        /// <summary>
        /// Starts the connections: two, or one with ROS time. They connect and reconnect automatically. Does nothing while connected.
        /// </summary>
        /// <remarks>This method, <see cref="Disconnect"/> and <see cref="Dispose"/> do not wait for the network.</remarks>
        public void Connect() => _connections.Connect();

        /// <summary>
        /// Ends the connections and returns at once. The state is kept: the pose is held, and the clock goes into holdover.
        /// </summary>
        public void Disconnect() => _connections.Disconnect();

        public void Dispose() => _connections.Dispose();

        /// <summary>Computes the frame to display. Allocates nothing after the first calls.</summary>
        /// <param name="start">Headset time of the frame's start.</param>
        /// <param name="isLast">
        /// False if the frame is computed again before it is rendered, see <see cref="SessionSettings.RewriteBeforeRender"/>.
        /// L_visu is calibrated from the last computation, so predicted display times are compared with it only there.
        /// </param>
        /// <returns>The session's own frame, which the next tick overwrites.</returns>
        public DisplayFrame Tick(HeadsetTime start, bool isLast = true)
        {
            lock (_gate)
            {
                var clock = _displayClock.Follow(_synchroniser.ModelAt(start), start);
                if (_displayClock.IsRestarted) Restart(start, clock);
                Intake.TakeAll(clock);
                var seen = _display.Light.LightOf(start, isComparable: isLast && _display.RenderTimes.State != RangeState.Outside);
                var light = clock.IsKnown ? clock.ToControl(seen) : (ControlTime?)null;
                _frame.IsDisplayTimeImplausible = _display.Light.IsImplausible;
                _frame.IsBeyondCalibration = _display.RenderTimes.IsBeyond;
                _frame.Update(start, light, clock, Settings.Clock.Trusts(clock), _display.RenderTimes.State, _display.Light.IsInconsistent,
                    _joints.IsAnyReportedMissing(start));
                if (isLast) _currentShare.Add(start, _frame.State == PoseState.Current);
                _hindcast.Shown(_frame, clock.ErrorBound);
                Ticked?.Invoke(_frame);
                return _frame;
            }
        }

        /// <summary>
        /// Applies a calibration from the next frame on: L_visu, and the range for render times. The session continues. The caller checks
        /// that the profile is for this device. Thread-safe.
        /// </summary>
        /// <param name="profile">
        /// Null restores the values of the settings. The range of the settings is also used if the profile has none, because the limit of
        /// the render time does not depend on how L_visu was measured.
        /// </param>
        public void Calibrate(LatencyProfile profile) => _display.Calibrate(profile);

        /// <summary>Reports the render time of a frame, which shows whether L_visu has its calibrated value. Once per frame. Thread-safe.</summary>
        /// <param name="renderTime">Δt_render. Zero and negative values are not measurements and are ignored.</param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when the render time is not measured any more.</param>
        public void Rendered(TimeSpan renderTime, RenderTimeSourceKind source) => _display.Rendered(renderTime, source);

        /// <summary>Reads a received robot description, which may take some time. Thread-safe.</summary>
        public void Described(string urdf)
        {
            if (!_description.Receive(urdf)) Drops.Count(DropReason.NotUrdf);
        }

        /// <summary>Starts a new run of <see cref="SessionStatistics.ToolErrorOfRun"/> with the next frame. Thread-safe.</summary>
        public void RestartErrorRun()
        {
            lock (_gate) _hindcast.RestartRun();
        }

        /// <summary>Returns a snapshot for panels and reports; allocates. Thread-safe.</summary>
        /// <param name="now">Headset time at which the clock's offset and error bound are evaluated.</param>
        public SessionStatistics Statistics(HeadsetTime now)
        {
            var statistics = new SessionStatistics();
            Fill(statistics, now);
            return statistics;
        }

        /// <summary>Writes the same snapshot into a reusable object; allocates nothing. Thread-safe.</summary>
        /// <param name="now">Headset time at which the clock's offset and error bound are evaluated.</param>
        public void Fill(SessionStatistics into, HeadsetTime now)
        {
            lock (_gate)
            {
                _measurements.Fill(into, now, this);
                into.BeyondLimits = _tracks.Limits.Present;
                into.CurrentShare = _currentShare.Value;
                _joints.Fill(into.ChangeableJointStatuses, now, into.Clock, _frame.DisplayTime);
            }
        }

        /// <summary>
        /// Returns the joints of the newest frame, stamped with its display time. Null while the display time is unknown, when a joint of the
        /// arm is missing, or when this frame was already returned. Thread-safe. Frames do no work for it.
        /// </summary>
        public JointStateMessage Displayed()
        {
            lock (_gate) return _displayed.Take();
        }

        // Time stamps from before a step belong to another time line, and those from before the first exchange were not validated: one
        // from the future would hold the pose until that time.
        void Restart(HeadsetTime now, in ClockModel clock)
        {
            _tracks.Reset();
            _latency.Reset();
            _hindcast.Reset();
            Restarted?.Invoke(now, clock);
        }
    }
}
