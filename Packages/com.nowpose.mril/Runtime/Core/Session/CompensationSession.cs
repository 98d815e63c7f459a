using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Cell;
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
        readonly Subscriptions _subscriptions = new Subscriptions();
        readonly SessionRobot _main;
        readonly CurrentShare _currentShare = new CurrentShare();
        readonly SessionMeasurements _measurements;
        readonly ApplicationLatency _latency = new ApplicationLatency();
        readonly object _gate = new object();
        readonly SessionDisplay _display;
        readonly SessionConnections _connections;

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
            _display = new SessionDisplay(settings, _gate);
            _synchroniser = new ClockSynchroniser(settings.CreateClockEstimator(), settings.Clock);
            Frames = new SessionFrames(settings.Prediction, _subscriptions, Drops);
            Signals = new SessionSignals(_subscriptions, Drops);
            Grips = new SessionGrips(Signals);
            Robots = new SessionRobots(settings, _latency, Drops, Frames, _subscriptions, _gate);
            _main = Robots.Add(settings.RobotNamespace, robot);
            _measurements = new SessionMeasurements(_synchroniser, _latency, _display, _main.Frame, _main.Hindcast);
            Listener = new SessionListener(this, clock);
            _connections = new SessionConnections(settings, clock, newLink, Listener, _subscriptions, _synchroniser, SyncFaults);
        }

        /// <summary>The robot of <see cref="SessionSettings.RobotNamespace"/>, to which the session's statistics and frames refer.</summary>
        public RobotModel Robot => _main.Robot;

        /// <summary>All robots of the cell, that robot first.</summary>
        internal SessionRobots Robots { get; }

        /// <summary>Objects of the cell. On the thread of <see cref="Tick"/>.</summary>
        internal SessionFrames Frames { get; }

        /// <summary>Signals of the cell. On the thread of <see cref="Tick"/>.</summary>
        internal SessionSignals Signals { get; }

        /// <summary>Grippers that take objects by their reach. On the thread of <see cref="Tick"/>.</summary>
        internal SessionGrips Grips { get; }

        /// <summary>Receives messages from the network or from a simulation. Thread-safe.</summary>
        internal IRosbridgeListener Listener { get; }

        /// <summary>Queues of messages for the next frame.</summary>
        internal SessionIntake Intake => _main.Intake;

        public SessionSettings Settings { get; }

        /// <summary>A sentence if the version of the gateway does not fit this one; null if it fits or is unknown. Set on the socket's thread.</summary>
        internal string VersionMismatch { get; set; }

        /// <summary>URDF text of the robot from the gateway, the newest valid one; null before. Thread-safe.</summary>
        public string RobotDescription => _main.Description.Text;

        /// <summary>Robot model of <see cref="RobotDescription"/>; null before. Thread-safe.</summary>
        public RobotModel DescribedRobot => _main.Description.Model;

        /// <summary>Whether <see cref="Robot"/> was read from the same text. Thread-safe.</summary>
        internal RobotDescriptionMatch RobotDescriptionMatch => _main.Description.Match;

        /// <summary>Reason why the newest description could not be read, in one line; null if there is none. Thread-safe.</summary>
        public string RobotDescriptionFault => _main.Description.Fault;

        /// <summary>
        /// Joints whose samples are outside the robot's limits, so that they are drawn in another position. Each is listed once, in the
        /// order of detection. On the thread of <see cref="Tick"/>.
        /// </summary>
        public IReadOnlyList<JointBeyondLimits> BeyondLimits => _main.Limits.Found;

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

        /// <summary>Counts of dropped messages by reason.</summary>
        internal DropCounters Drops { get; } = new DropCounters();

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
        /// Newest display time from <see cref="DisplayTimeSource"/> minus its frame's start, used or not; null if there is none. Thread-safe.
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
                Robots.Take(clock);
                var seen = _display.Light.LightOf(start, isComparable: isLast && _display.RenderTimes.State != RangeState.Outside);
                var light = clock.IsKnown ? clock.ToControl(seen) : (ControlTime?)null;
                Show(new DisplayMoment(start, light, clock, Settings.Clock.Trusts(clock), _display.Light, _display.RenderTimes));
                if (isLast) _currentShare.Add(start, _main.IsCurrent);
                Ticked?.Invoke(_main.Frame);
                return _main.Frame;
            }
        }

        void Show(in DisplayMoment moment)
        {
            Robots.Show(moment);
            Frames.Take(moment);
            Signals.Show(moment);
            // A gripper takes an object in the frame in which its signal's change is visible.
            Grips.Decide(moment);
            Frames.Show(moment);
            Robots.PlaceRoots();
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
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when the render time is no longer measured.</param>
        public void Rendered(TimeSpan renderTime, RenderTimeSourceKind source) => _display.Rendered(renderTime, source);

        /// <summary>Reads a received robot description, which may take some time. Thread-safe.</summary>
        public void Described(string urdf) => Listener.Described(urdf, _main.Namespace);

        /// <summary>Starts a new run of <see cref="SessionStatistics.ToolErrorOfRun"/> with the next frame. Thread-safe.</summary>
        public void RestartErrorRun()
        {
            lock (_gate) _main.Hindcast.RestartRun();
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
                into.BeyondLimits = _main.Limits.Present;
                into.CurrentShare = _currentShare.Value;
                _main.Joints.Fill(into.ChangeableJointStatuses, now, into.Clock, _main.Frame.DisplayTime);
            }
        }

        /// <summary>
        /// Returns the joints of the newest frame, stamped with its display time. Null while the display time is unknown, when a joint of the
        /// arm is missing, or when this frame was already returned. Thread-safe. Frames do no work for it.
        /// </summary>
        public JointStateMessage Displayed()
        {
            lock (_gate) return _main.Displayed();
        }

        // Time stamps from before a step belong to another time line, and those from before the first exchange were not validated: one
        // from the future would hold the pose until that time.
        void Restart(HeadsetTime now, in ClockModel clock)
        {
            _latency.Reset();
            Grips.Settle();
            Robots.Restart();
            Frames.Restart();
            Signals.Table.Restart();
            Restarted?.Invoke(now, clock);
        }
    }
}
