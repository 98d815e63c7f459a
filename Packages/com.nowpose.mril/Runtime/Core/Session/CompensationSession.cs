using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.DisplayTime;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;

namespace Nowpose.Session
{
    /// <summary>The headset runtime: synchronises the clock, measures how late samples are, and shows the robot at the moment of light.</summary>
    /// <remarks>
    /// The method of Schnierle &amp; Röck 2022. The same object runs in Unity, in the command line and in tests: it never
    /// reads a clock in <see cref="Tick"/> and needs no network for it. <see cref="Tick"/>, <see cref="Connect"/>,
    /// <see cref="Disconnect"/> and <see cref="Dispose"/> belong to one thread, the frame's; everything else may be called
    /// from any. It never commands the robot.
    /// </remarks>
    public sealed class CompensationSession : IDisposable
    {
        readonly SessionSettings _settings;
        readonly IHeadsetClock _clock;
        readonly ClockSynchroniser _synchroniser;
        readonly DisplayClock _displayClock = new DisplayClock();
        readonly JointTracks _tracks;
        readonly DisplayFrame _frame;
        readonly JointWatch _joints;
        readonly CurrentShare _currentShare = new CurrentShare();
        readonly ConstantLatencyMonitor _monitor;
        readonly HindcastMonitor _hindcast;
        readonly SessionMeasurements _measurements;
        readonly ApplicationLatency _latency = new ApplicationLatency();
        readonly MomentOfLight _light;
        readonly object _gate = new object();
        volatile ReceivedDescription _description = ReceivedDescription.None;
        volatile string _descriptionFault;
        readonly SessionConnections _connections;
        readonly string[] _jointNames;
        ControlTime _told;
        DepthSubmission _depth;
        readonly ConditionCheck _conditions;
        bool _wasKnown;
        int _steps;

        /// <param name="robot">Its moving joints are matched with the samples' names.</param>
        /// <param name="clock">Stamps what the network threads receive.</param>
        public CompensationSession(SessionSettings settings, RobotModel robot, IHeadsetClock clock)
            : this(settings, robot, clock, WebSocketLinks.Create)
        {
        }

        /// <param name="newLink">Makes the WebSocket of each attempt to connect.</param>
        internal CompensationSession(
            SessionSettings settings, RobotModel robot, IHeadsetClock clock, Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> newLink)
        {
            _settings = settings;
            _clock = clock;
            Robot = robot;
            _jointNames = robot.MovingJoints.Select(joint => joint.Name).ToArray();
            _conditions = new ConditionCheck(settings.RewriteBeforeRender);
            _light = new MomentOfLight(settings.Visualisation, settings.Profile);
            _synchroniser = new ClockSynchroniser(settings.CreateClockEstimator(), settings.Clock);
            _monitor = new ConstantLatencyMonitor(settings.Range);
            _tracks = new JointTracks(robot, settings.Prediction);
            _frame = new DisplayFrame(robot, _tracks, settings.OutsideRange);
            _joints = new JointWatch(robot, _tracks, settings.Prediction.HorizonCap);
            _hindcast = new HindcastMonitor(robot, settings.Prediction.MaximumGap);
            _tracks.StartedAnew += _hindcast.StartAnew;
            _measurements = new SessionMeasurements(_synchroniser, _latency, _light, _monitor, _frame, _hindcast);
            Intake = new SessionIntake(robot, _tracks, _hindcast, _latency, settings.Prediction.FollowsPlans);
            Listener = new SessionListener(this, Intake, _joints, clock);
            _connections = new SessionConnections(settings, clock, newLink, Listener, _synchroniser, SyncFaults);
        }

        public RobotModel Robot { get; }

        /// <summary>Takes what arrives over the network, and what takes its place in simulations. Any thread.</summary>
        internal IRosbridgeListener Listener { get; }

        /// <summary>The messages on their way into a frame.</summary>
        internal SessionIntake Intake { get; }

        public SessionSettings Settings => _settings;

        /// <summary>URDF text of the robot as the gateway describes it, the newest that could be read; null before. Any thread.</summary>
        public string RobotDescription => _description.Text;

        /// <summary>The robot that <see cref="RobotDescription"/> describes, read already; null before. Any thread.</summary>
        public RobotModel DescribedRobot => _description.Model;

        /// <summary>Whether <see cref="Robot"/> was read from the same text. Any thread.</summary>
        internal RobotDescriptionMatch RobotDescriptionMatch => _description.Match;

        /// <summary>Why the newest description could not be read, in one line; null when it could, or there is none. Any thread.</summary>
        public string RobotDescriptionFault => _descriptionFault;

        /// <summary>
        /// Joints whose samples were outside the robot's limits, so that they are drawn elsewhere than they are; in the order in which they
        /// were found, each once. On the thread of <see cref="Tick"/>.
        /// </summary>
        public IReadOnlyList<JointBeyondLimits> BeyondLimits => _tracks.Limits.Found;

        /// <summary>Takes sync exchanges; the network feeds it, and so may a test. A frame follows it without going back.</summary>
        internal ClockSynchroniser Clock => _synchroniser;

        /// <summary>
        /// All samples are forgotten, for the clock stepped or became known; raised within <see cref="Tick"/>, before it takes
        /// others.
        /// </summary>
        public event Action<HeadsetTime, ClockModel> StartedAnew;

        /// <summary>A frame as it was computed; raised at the end of each <see cref="Tick"/>.</summary>
        /// <remarks>
        /// A handler must be quick, must not throw, and must not call methods of the session but <see cref="Fill"/>; properties may be read.
        /// </remarks>
        public event Action<DisplayFrame> Ticked;

        /// <summary>As of <see cref="HindcastMonitor.ToolJudged"/>; raised within <see cref="Tick"/>.</summary>
        internal event Action<ControlTime, PoseState, ErrorSample> ToolJudged
        {
            add => _hindcast.ToolJudged += value;
            remove => _hindcast.ToolJudged -= value;
        }

        /// <summary>What was dropped, by reason.</summary>
        internal DropCounters Drops => Intake.Drops;

        /// <summary>Sync exchanges that were dropped, by reason.</summary>
        internal SyncFaultCounters SyncFaults { get; } = new SyncFaultCounters();

        /// <summary>L_visu as calibrated. May change while the session runs; setting it says that it comes from no profile.</summary>
        public VisualisationLatency Visualisation
        {
            get { lock (_gate) return _light.Calibrated; }
            set { lock (_gate) _light.Calibrated = value; }
        }

        /// <summary>What <see cref="Visualisation"/> comes from; null when it was told as a number. Any thread.</summary>
        public LatencyProfile Profile
        {
            get { lock (_gate) return _light.Profile; }
        }

        /// <summary>What render times are judged by: the profile's range, or else the settings'; null where neither knows one. Any thread.</summary>
        public ConstantLatencyRange Range
        {
            get { lock (_gate) return _monitor.Range; }
        }

        /// <summary>
        /// Tells when light appears, frame by frame, and is believed before <see cref="Visualisation"/>; null for none. Asked within
        /// <see cref="Tick"/>; must not call back into the session. Any thread may set it.
        /// </summary>
        public IDisplayTimeSource DisplayTimeSource
        {
            get { lock (_gate) return _light.Source; }
            set { lock (_gate) _light.Source = value; }
        }

        /// <summary>Whether the light of the newest frame is as <see cref="DisplayTimeSource"/> told; else as calibrated. Any thread.</summary>
        public bool IsLightPredicted
        {
            get { lock (_gate) return _light.IsPredicted; }
        }

        /// <summary>
        /// Newest answer of <see cref="DisplayTimeSource"/> minus its frame's start, used or not; null while there is none. Any thread.
        /// </summary>
        public TimeSpan? DisplayTimeAhead
        {
            get { lock (_gate) return _light.Ahead; }
        }

        /// <summary>
        /// How the display corrects frames for head motion, as reported from outside; it does not change what a frame
        /// shows. Any thread.
        /// </summary>
        public ReprojectionMode Reprojection
        {
            get { lock (_gate) return _conditions.Reprojection; }
            set { lock (_gate) _conditions.Reprojection = value; }
        }

        /// <summary>
        /// Conditions that change L_visu. Set to those that the device reports; read with <see cref="Reprojection"/> and the settings' second
        /// computation before rendering. They do not change what a frame shows. Any thread.
        /// </summary>
        internal DisplayConditions Conditions
        {
            get { lock (_gate) return _conditions.Conditions; }
            set { lock (_gate) _conditions.Report(value); }
        }

        /// <summary>Conditions in which <see cref="Profile"/> was measured and that are different now; empty for none. Any thread.</summary>
        public IReadOnlyList<ConditionMismatch> ProfileMismatches
        {
            get { lock (_gate) return _conditions.MismatchesOf(_light.Profile); }
        }

        /// <summary>Whether the depth buffer reaches the display, as reported from outside. Any thread.</summary>
        public DepthSubmission DepthSubmission
        {
            get { lock (_gate) return _depth; }
            set { lock (_gate) _depth = value; }
        }

        /// <summary>Δt_render as <see cref="Rendered"/> was told it last; null while nothing measures.</summary>
        public TimeSpan? NewestRenderTime { get; private set; }

        /// <summary>Completes when the connections that were ended are gone, sockets, threads and all; nobody has to wait for it.</summary>
        public Task Ended => _connections.Ended;

        /// <summary>Where the connection of the clock sync stands, or the exchanges of ROS's time. Any thread.</summary>
        public LinkStatus SyncLink => _connections.SyncLink;

        /// <summary>Where the connection of the joint positions stands. Any thread.</summary>
        public LinkStatus SampleLink => _connections.SampleLink;

        /// <summary>
        /// Starts the connections, both or, by ROS's time, one; they come up, and come back, by themselves. Does nothing while connected.
        /// </summary>
        /// <remarks>Neither this nor <see cref="Disconnect"/> nor <see cref="Dispose"/> waits for the network.</remarks>
        public void Connect() => _connections.Connect();

        /// <summary>
        /// Ends the connections; returns at once. What is known stays: the pose is held, the clock goes into holdover.
        /// </summary>
        public void Disconnect() => _connections.Disconnect();

        public void Dispose() => _connections.Dispose();

        /// <summary>Computes what a frame displays. Allocates nothing once warm.</summary>
        /// <param name="start">Headset time at which the frame begins.</param>
        /// <param name="isLast">
        /// False where the frame is computed once more before it is rendered, as with <see cref="SessionSettings.RewriteBeforeRender"/>.
        /// L_visu is calibrated from the last one, so only there are predicted display times compared with it.
        /// </param>
        /// <returns>The session's own frame, overwritten by the next tick.</returns>
        public DisplayFrame Tick(HeadsetTime start, bool isLast = true)
        {
            lock (_gate)
            {
                var clock = _displayClock.Follow(_synchroniser.ModelAt(start), start);
                ForgetWhatAnotherClockStamped(start, clock);
                Intake.TakeAll(clock);
                var seen = _light.LightOf(start, isComparable: isLast && _monitor.State != RangeState.Outside);
                var light = clock.IsKnown ? clock.ToControl(seen) : (ControlTime?)null;
                _frame.IsDisplayTimeImplausible = _light.IsImplausible;
                _frame.Update(
                    start, light, clock, _settings.Clock.Trusts(clock), _monitor.State, _light.IsDoubted, _joints.IsAnyReportedMissing(start));
                if (isLast) _currentShare.Add(start, _frame.State == PoseState.Current);
                _hindcast.Shown(_frame, clock.ErrorBound);
                Ticked?.Invoke(_frame);
                return _frame;
            }
        }

        /// <summary>
        /// Takes what a calibration found, from the next frame on: L_visu, and the range that render times are judged by. The
        /// session goes on. Whether the profile is of this device is for the caller to ask. Any thread.
        /// </summary>
        /// <param name="profile">
        /// Null goes back to what the settings say; their range also counts where the profile knows none, for what limits the render
        /// time has nothing to do with how L_visu was found.
        /// </param>
        public void Calibrate(LatencyProfile profile)
        {
            lock (_gate)
            {
                _light.Calibrate(profile?.Visualisation ?? _settings.Visualisation, profile ?? _settings.Profile);
                _monitor.Range = profile?.WatchedRange ?? _settings.Range;
            }
        }

        /// <summary>How long the render job of a frame took: tells whether L_visu is the calibrated one. Once a frame; any thread.</summary>
        /// <param name="renderTime">Δt_render. Zero or less is no measurement and is ignored.</param>
        /// <param name="source"><see cref="RenderTimeSourceKind.None"/> when nothing measures any more.</param>
        public void Rendered(TimeSpan renderTime, RenderTimeSourceKind source)
        {
            lock (_gate)
            {
                _monitor.Add(renderTime, source);
                NewestRenderTime = source != RenderTimeSourceKind.None && renderTime > TimeSpan.Zero ? renderTime : (TimeSpan?)null;
            }
        }

        /// <summary>A robot description; read here, which takes its time. Any thread.</summary>
        public void Described(string urdf)
        {
            string fault = null;
            // The same again after each reconnection.
            if (urdf != _description.Text)
            {
                if (ReceivedDescription.TryRead(urdf, Robot, out var description, out fault)) _description = description;
                else Drops.Count(DropReason.NotUrdf);
            }
            _descriptionFault = fault;
        }

        /// <summary>Begins a new run for <see cref="SessionStatistics.ToolErrorOfRun"/>, with the next frame. Any thread.</summary>
        public void RestartErrorRun()
        {
            lock (_gate) _hindcast.RestartRun();
        }

        /// <summary>A snapshot for panels and reports; allocates. Any thread.</summary>
        /// <param name="now">Headset time for the clock's offset and bound.</param>
        public SessionStatistics Statistics(HeadsetTime now)
        {
            var statistics = new SessionStatistics();
            Fill(statistics, now);
            return statistics;
        }

        /// <summary>The same snapshot into an object that is used again and again: allocates nothing. Any thread.</summary>
        /// <param name="now">Headset time for the clock's offset and bound.</param>
        public void Fill(SessionStatistics into, HeadsetTime now)
        {
            lock (_gate)
            {
                _measurements.Fill(into, now);
                into.RobotDescriptionMatch = RobotDescriptionMatch;
                into.BeyondLimits = _tracks.Limits.Present;
                into.CurrentShare = _currentShare.Value;
                _joints.Fill(into.ChangeableJointStatuses, now, into.Clock, _frame.DisplayTime);
                into.Samples = Intake.Samples;
                into.Dropped = Drops.Total + SyncFaults.Total;
                into.SyncLink = SyncLink;
                into.SampleLink = SampleLink;
                into.Reprojection = _conditions.Reprojection;
                into.DepthSubmission = _depth;
                into.ProfileMismatches = _conditions.MismatchesOf(_light.Profile);
                into.Security = _settings.Connection.Security;
            }
        }

        /// <summary>
        /// What the newest frame shows, stamped with its moment of light; null while that is not known, a joint of the arm is missing,
        /// or the frame was told already. Any thread: a frame does nothing for it.
        /// </summary>
        public JointStateMessage Displayed()
        {
            lock (_gate)
            {
                if (!(_frame.DisplayTime is ControlTime light) || !_frame.IsTimeTrusted || _frame.State == PoseState.Incomplete) return null;
                if (light == _told) return null;
                _told = light;
                return new JointStateMessage(light, _jointNames, _frame.Joints.ToArray(), frameId: _settings.Connection.HeadsetName);
            }
        }

        // Stamps from before a step belong to another time line, and stamps from before the first exchange were never
        // checked: one from the future would hold the display for as long.
        void ForgetWhatAnotherClockStamped(HeadsetTime now, in ClockModel clock)
        {
            if (_steps == clock.Steps && _wasKnown == clock.IsKnown) return;
            _steps = clock.Steps;
            _wasKnown = clock.IsKnown;
            _tracks.Reset();
            _latency.Reset();
            _hindcast.Reset();
            StartedAnew?.Invoke(now, clock);
        }
    }
}
