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
    /// <summary>
    /// Headset runtime: synchronises the clock, measures the latency of samples, and computes the robot's pose at the display time.
    /// </summary>
    /// <remarks>
    /// Implements the method of Schnierle &amp; Röck 2022. The same class runs in Unity, in the command line tool and in tests:
    /// <see cref="Tick"/> reads no clock and needs no network. Call <see cref="Tick"/>, <see cref="Connect"/>, <see cref="Disconnect"/> and
    /// <see cref="Dispose"/> only on the frame loop's thread; all other members are thread-safe unless stated otherwise. The session never
    /// commands the robot.
    /// </remarks>
    public sealed class CompensationSession : IDisposable
    {
        readonly ClockSynchroniser _synchroniser;
        readonly DisplayClock _displayClock = new DisplayClock();
        readonly Subscriptions _subscriptions = new Subscriptions();
        readonly SessionCell _cell;
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
            _cell = new SessionCell(settings, _latency, Drops, _subscriptions, _gate);
            _main = Robots.Add(settings.RobotNamespace, robot);
            _measurements = new SessionMeasurements(_synchroniser, _latency, _display, _main.Frame, _main.Hindcast);
            Listener = new SessionListener(this, clock);
            _connections = new SessionConnections(settings, clock, newLink, Listener, _subscriptions, _synchroniser, SyncFaults);
        }

        /// <summary>The robot of <see cref="SessionSettings.RobotNamespace"/>, to which the session's statistics and frames refer.</summary>
        public RobotModel Robot => _main.Robot;

        /// <summary>All robots of the cell; <see cref="Robot"/> is the first.</summary>
        internal SessionRobots Robots => _cell.Robots;

        /// <summary>Coordinate frames of the objects in the cell. Use them only on the thread of <see cref="Tick"/>.</summary>
        internal SessionFrames Frames => _cell.Frames;

        /// <summary>Signals of the cell. Use them only on the thread of <see cref="Tick"/>.</summary>
        internal SessionSignals Signals => _cell.Signals;

        /// <summary>Grippers that grip objects within their reach. Use them only on the thread of <see cref="Tick"/>.</summary>
        internal SessionGrips Grips => _cell.Grips;

        /// <summary>Everything that the session shows of the cell.</summary>
        internal SessionCell Cell => _cell;

        /// <summary>Receives messages from the network or from a simulation. Thread-safe.</summary>
        internal IRosbridgeListener Listener { get; }

        /// <summary>Queues of messages for the next frame.</summary>
        internal SessionIntake Intake => _main.Intake;

        public SessionSettings Settings { get; }

        /// <summary>
        /// Message if the gateway's version is incompatible with this version; null if the versions are compatible or the gateway's version
        /// is unknown. Set on the socket's thread.
        /// </summary>
        internal string VersionMismatch { get; set; }

        /// <summary>Newest valid URDF text of the robot from the gateway; null before the first. Thread-safe.</summary>
        public string RobotDescription => _main.Description.Text;

        /// <summary>Robot model of <see cref="RobotDescription"/>; null before the first description. Thread-safe.</summary>
        public RobotModel DescribedRobot => _main.Description.Model;

        /// <summary>Result of comparing <see cref="Robot"/> with the gateway's description. Thread-safe.</summary>
        internal RobotDescriptionMatch RobotDescriptionMatch => _main.Description.Match;

        /// <summary>Reason why the newest description could not be read, in one line; null if there is none. Thread-safe.</summary>
        public string RobotDescriptionFault => _main.Description.Fault;

        /// <summary>
        /// Joints with samples outside the limits of the robot model, so that the drawn positions are wrong. Each joint is listed once, in the
        /// order of detection. Use the list only on the thread of <see cref="Tick"/>.
        /// </summary>
        public IReadOnlyList<JointBeyondLimits> BeyondLimits => _main.Limits.Found;

        /// <summary>Clock synchroniser. It receives exchanges from the network or a test; the displayed time follows it without going back.</summary>
        internal ClockSynchroniser Clock => _synchroniser;

        /// <summary>
        /// Raised when the session removes all samples because the clock stepped or became known. Raised within <see cref="Tick"/>, before
        /// new samples are processed.
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

        /// <summary>Profile of <see cref="Visualisation"/>; null if the value was set as a number. Thread-safe.</summary>
        public LatencyProfile Profile => _display.Profile;

        /// <summary>Constant-latency range of the profile, or else of the settings; null if neither has a range. Thread-safe.</summary>
        public ConstantLatencyRange Range => _display.Range;

        /// <summary>
        /// Source of display times; null if there is none. While it provides a display time, <see cref="Visualisation"/> is not used. The session
        /// calls it within <see cref="Tick"/>; it must not call the session. May be set on any thread.
        /// </summary>
        public IDisplayTimeSource DisplayTimeSource { get => _display.Source; set => _display.Source = value; }

        /// <summary>Whether the newest frame's display time comes from <see cref="DisplayTimeSource"/>, not the calibration. Thread-safe.</summary>
        public bool IsLightPredicted => _display.IsLightPredicted;

        /// <summary>
        /// Newest display time from <see cref="DisplayTimeSource"/> minus the start of its frame, even if it was not used; null if there is none.
        /// Thread-safe.
        /// </summary>
        public TimeSpan? DisplayTimeAhead => _display.Ahead;

        /// <summary>
        /// Reprojection mode of the display, as set by the caller. It does not change what a frame shows. Thread-safe.
        /// </summary>
        public ReprojectionMode Reprojection { get => _display.Reprojection; set => _display.Reprojection = value; }

        /// <summary>
        /// Conditions that affect L_visu. Set the conditions that the device reports; the value read also includes <see cref="Reprojection"/> and
        /// <see cref="SessionSettings.RewriteBeforeRender"/>. They do not change what a frame shows. Thread-safe.
        /// </summary>
        internal DisplayConditions Conditions { get => _display.Conditions; set => _display.Conditions = value; }

        /// <summary>Conditions that differ from those under which <see cref="Profile"/> was measured; empty if none differ. Thread-safe.</summary>
        public IReadOnlyList<ConditionMismatch> ProfileMismatches => _display.ProfileMismatches;

        /// <summary>Whether the depth buffer reaches the display, as set by the caller. Thread-safe.</summary>
        public DepthSubmission DepthSubmission { get => _display.DepthSubmission; set => _display.DepthSubmission = value; }

        /// <summary>Δt_render of the newest call of <see cref="Rendered"/>; null when the render time is not measured.</summary>
        public TimeSpan? NewestRenderTime => _display.NewestRenderTime;

        /// <summary>Completes when the ended connections have released their sockets, threads and other resources; waiting is optional.</summary>
        public Task Ended => _connections.Ended;

        /// <summary>Status of the clock sync connection, or of the exchanges over rosbridge if ROS time is the control clock. Thread-safe.</summary>
        public LinkStatus SyncLink => _connections.SyncLink;

        /// <summary>Status of the connection for joint positions. Thread-safe.</summary>
        public LinkStatus SampleLink => _connections.SampleLink;

        /// <summary>Whether values of signals can arrive: over the connection, or from a program that supplies this session.</summary>
        internal bool CanReceiveSignals =>
            SampleLink.State == LinkState.Connected || (!_connections.WasRequested && Signals.Table.Count > 0);

        /// <summary>
        /// Starts the connections: two, or only one with ROS time. They connect and reconnect automatically. Does nothing while connected.
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
        /// False if the frame is computed again before it is rendered, see <see cref="SessionSettings.RewriteBeforeRender"/>. L_visu is calibrated
        /// for the last computation, so only that one is compared with predicted display times, displayed, scored and recorded.
        /// </param>
        /// <returns>The session's own frame, which the next tick overwrites.</returns>
        public DisplayFrame Tick(HeadsetTime start, bool isLast = true)
        {
            lock (_gate)
            {
                var clock = _displayClock.Follow(_synchroniser.ModelAt(start), start);
                if (_displayClock.IsRestarted) Restart(start, clock);
                Robots.Take(clock);
                if (isLast) _display.Started(start);
                var displayTime = _display.Selector.LightOf(start, isComparable: isLast && _display.RenderTimes.State != RangeState.Outside);
                var onControlClock = clock.IsKnown ? clock.ToControl(displayTime) : (ControlTime?)null;
                var isTrusted = Settings.Clock.Trusts(clock);
                _cell.Show(new DisplayMoment(start, onControlClock, clock, isTrusted, _display.Selector, _display.RenderTimes, isLast), CanReceiveSignals);
                if (isLast) _currentShare.Add(start, Robots.WorstPose == PoseState.Current);
                Ticked?.Invoke(_main.Frame);
                return _main.Frame;
            }
        }

        /// <summary>
        /// Applies a calibration (L_visu and the range of render times) from the next frame on. The session continues. The caller checks that
        /// the profile is for this device. Thread-safe.
        /// </summary>
        /// <param name="profile">
        /// Null restores the values of the settings. The range of the settings is also used if the profile has none, because the limit of
        /// the render time does not depend on how L_visu was measured.
        /// </param>
        public void Calibrate(LatencyProfile profile) => _display.Calibrate(profile);

        /// <summary>Reports the render time of a frame, to check that L_visu has its calibrated value. Call it once per frame. Thread-safe.</summary>
        /// <param name="renderTime">Δt_render. Zero and negative values are not measurements and are ignored.</param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when the render time is no longer measured.</param>
        public void Rendered(TimeSpan renderTime, RenderTimeSourceKind source) => _display.Rendered(renderTime, source);

        /// <summary>Reads a received robot description; this may take some time. Thread-safe.</summary>
        public void Described(string urdf) => Listener.Described(urdf, _main.Namespace);

        /// <summary>Restarts the measurement of <see cref="SessionStatistics.ToolErrorOfRun"/> with the next frame. Thread-safe.</summary>
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

        /// <summary>Writes the snapshot of <see cref="Statistics"/> into a reusable object; allocates nothing. Thread-safe.</summary>
        /// <param name="now">Headset time at which the clock's offset and error bound are evaluated.</param>
        public void Fill(SessionStatistics into, HeadsetTime now)
        {
            lock (_gate)
            {
                _measurements.Fill(into, now, this);
                into.CurrentShare = _currentShare.Value;
            }
        }

        /// <summary>The most severe state among the poses of all robots, held if no frames are computed. Thread-safe.</summary>
        internal PoseState ReadWorstPose(HeadsetTime now)
        {
            lock (_gate) return Robots.WorstPoseAt(now);
        }

        /// <summary>
        /// Returns the joints of the newest frame, stamped with its display time. Null while the display time is unknown or too inaccurate,
        /// while a joint of the arm has no sample, and if this frame was already returned. Thread-safe.
        /// </summary>
        public JointStateMessage Displayed()
        {
            lock (_gate) return _main.Displayed();
        }

        // Stamps from before a step cannot be compared with later stamps. Stamps from before the first exchange were not validated, and a
        // stamp in the future would hold the pose until that time.
        void Restart(HeadsetTime now, in ClockModel clock)
        {
            _latency.Reset();
            _cell.Restart();
            Restarted?.Invoke(now, clock);
        }
    }
}
