using System;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Samples
{
    /// <summary>
    /// Simulates a control system in the scene: one or two robots that take workpieces from a conveyor, its clock, and the network to the headset.
    /// </summary>
    /// <remarks>
    /// Replaces a gateway: supplies a session that is not connected with samples, sync exchanges and the robot's description. All settings except the
    /// number of robots and the seed can be changed while the scene plays.
    /// </remarks>
    [AddComponentMenu("Nowpose/Samples/Simulated Control System")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder - 1)]
    [DisallowMultipleComponent]
    public sealed class SimulatedControlSystem : MonoBehaviour
    {
        [SerializeField, Tooltip("The session that receives the samples. Turn its Connect On Enable off.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The robot that moves. The youBot has its own motion cycle; for other robots the cycle is derived from their "
            + "limits.")]
        RobotDescriptionAsset _robot = null;

        [SerializeField, Tooltip("Adds a second robot of the same kind that shares the conveyor. Read at the start of the simulation. The robots "
            + "then have the namespaces arm1 and arm2. Enter arm1 as Robot Namespace in the session's settings.")]
        bool _hasSecondRobot = false;

        [SerializeField, Tooltip("Publish the set-points of the next second, as a motion planner does. They are needed for Planned Path. If Follow "
            + "Plan is on in the session's settings, they also make the prediction more accurate.")]
        bool _publishesSetPoints = false;

        [SerializeField, Range(0, 500), Tooltip("Delay of the robots behind their set-points in ms.")]
        float _followingErrorMs = 20;

        [Header("Sampling")]
        [SerializeField, Range(5, 1000), Tooltip("Sampling interval T_s of the joints in ms. 50 ms is usual for a controller's interface. Beyond "
            + "the settings' Maximum Gap the pose is held.")]
        float _samplingMs = 50;

        [SerializeField, Range(0, 1000), Tooltip("Minimum time in ms from a sample until it is sent. 55 to 105 ms is the time of subscription "
            + "and middleware in the plant of Schnierle & Röck 2022.")]
        float _latencyMinMs = 55;

        [SerializeField, Range(0, 1000), Tooltip("Maximum time in ms from a sample until it is sent. All times between minimum and maximum are "
            + "equally likely. A value below the minimum counts as the minimum.")]
        float _latencyMaxMs = 105;

        [Header("Network")]
        [SerializeField, Tooltip("Delays and bursts of the simulated network, which apply to all packets.")]
        SimulatedNetwork _network = SimulatedNetwork.Wifi;

        [SerializeField, Range(0, 500), Tooltip("Maximum additional delay of each packet in ms, including clock exchanges. 2 ms has little "
            + "effect; tens of ms make the clock inaccurate.")]
        float _jitterMs = 2;

        [SerializeField, Range(0, 1), Tooltip("Fraction of lost packets. 0.01 is usual for WiFi; 1 interrupts the connection.")]
        float _loss = 0.01f;

        [Header("Control clock")]
        [SerializeField, Range(-1000, 1000), Tooltip("Control clock minus headset clock at the start, in seconds. A change during play steps the "
            + "clock, as a restart of the controller does.")]
        float _clockAheadSeconds = 100;

        [SerializeField, Range(-500, 500), Tooltip("Rate of the control clock minus that of the headset clock, ppm. 37 ppm is a usual difference "
            + "between two quartz clocks.")]
        float _skewPpm = 37;

        [Header("Random numbers")]
        [SerializeField, Tooltip("Seed of all delays and losses, read at the start of the simulation. The same seed gives the same delays.")]
        int _seed = 1;

        IHeadsetClock _time;
        VirtualClock _clock;
        VirtualCell _cell;
        CompensationSession _described;
        int _robots;

        /// <summary>The session that receives the data.</summary>
        public MrilSession Session => _session;

        /// <summary>The simulated robot; null while this component is not enabled.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>Gets the true joint positions of a robot at a given time.</summary>
        /// <param name="joints">Receives one position per moving joint of the robot, in rad or m.</param>
        /// <param name="isSecond">Whether the robot is the second one.</param>
        /// <returns>False if the simulation has not started, or if the cell has only one robot.</returns>
        public bool TryGetTruth(HeadsetTime at, Span<double> joints, bool isSecond = false)
        {
            if (_cell == null || (isSecond && _robots == 1)) return false;
            _cell.TruthAt(at, joints, isSecond ? 1 : 0);
            return true;
        }

        void OnEnable()
        {
            try
            {
                if (_session == null) throw new InputException("control system '" + name + "' has no session; assign one");
                if (_robot == null) throw new InputException("control system '" + name + "' has no robot; assign one");
                Robot = _robot.Read();
            }
            catch (InputException fault)
            {
                Debug.LogError("[Nowpose] " + fault.Message, this);
                enabled = false;
            }
        }

        void OnDisable()
        {
            Robot = null;
            _cell = null;
        }

        void LateUpdate()
        {
            var session = _session.Session;
            if (session == null) return;
            var now = _session.HeadsetClock.Now;
            if (_cell == null || _time != _session.HeadsetClock) Begin(now);
            if (_described != session) session.Described(_robot.Urdf);
            _described = session;
            _clock.Set(now, ClockAhead, _skewPpm * 1e-6);
            _cell.Settings = Knobs();
            _cell.PlanLag = _publishesSetPoints ? Milliseconds(_followingErrorMs) : (TimeSpan?)null;
            _cell.Run(now, session);
        }

        void Begin(HeadsetTime now)
        {
            _time = _session.HeadsetClock;
            _clock = new VirtualClock(now, ClockAhead, _skewPpm * 1e-6);
            _robots = _hasSecondRobot ? 2 : 1;
            _cell = VirtualCell.WithWorkpieces(Robot, new PickAndPlaceMotion(Robot), _clock, Knobs(), _seed, now, _robots);
            var (used, needed) = (_session.Settings.RobotNamespace, _hasSecondRobot ? "arm1" : "");
            if (used != needed)
                Debug.LogError("[Nowpose] control system '" + name + "' needs the Robot Namespace '" + needed + "' in the settings of its session, "
                    + "not '" + used + "'; change it there", this);
        }

        // TimeSpan.FromSeconds is not used, because in Unity it rounds to whole milliseconds.
        TimeSpan ClockAhead => TimeSpan.FromTicks((long)((double)_clockAheadSeconds * TimeSpan.TicksPerSecond));

        static TimeSpan Milliseconds(float ms) => TimeSpan.FromTicks((long)((double)ms * TimeSpan.TicksPerMillisecond));

        VirtualCellSettings Knobs() => new VirtualCellSettings(
            _samplingMs, _latencyMinMs, Mathf.Max(_latencyMinMs, _latencyMaxMs), _jitterMs, _loss, NetworkProfile.All[(int)_network]);
    }
}
