using System;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Samples
{
    /// <summary>A control system inside the scene: a pick-and-place robot, its clock, and the network to the headset.</summary>
    /// <remarks>
    /// Feeds a session that is not connected, as a gateway does: with samples, clock exchanges and the robot's description.
    /// All settings take effect while the scene plays.
    /// </remarks>
    [AddComponentMenu("Nowpose/Samples/Simulated Control System")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder - 1)]
    [DisallowMultipleComponent]
    public sealed class SimulatedControlSystem : MonoBehaviour
    {
        [SerializeField, Tooltip("The session to feed. Its Connect On Enable has to be off.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The robot that moves. The youBot has a cycle of its own, any other one that follows from its limits.")]
        RobotDescriptionAsset _robot = null;

        [Header("Sampling")]
        [SerializeField, Range(5, 1000), Tooltip("T_s in ms: from one sample of the joints to the next. 50 ms is what a controller's interface "
            + "usually gives; beyond the settings' Maximum Gap the pose is held.")]
        float _samplingMs = 50;

        [SerializeField, Range(0, 1000), Tooltip("Shortest time in ms from a sample until it is sent. 55 to 105 ms is what subscription and "
            + "middleware took in the plant of Schnierle & Röck 2022.")]
        float _latencyMinMs = 55;

        [SerializeField, Range(0, 1000), Tooltip("Longest, ms; in between all are equally likely. Below the shortest it counts as equal to it.")]
        float _latencyMaxMs = 105;

        [Header("Network")]
        [SerializeField, Tooltip("What all packets pass, with its usual delays and bursts.")]
        SimulatedNetwork _network = SimulatedNetwork.Wifi;

        [SerializeField, Range(0, 500), Tooltip("What each packet takes longer at most, ms, clock exchanges too. 2 ms hardly matters; tens of ms "
            + "cost the clock its accuracy.")]
        float _jitterMs = 2;

        [SerializeField, Range(0, 1), Tooltip("Share of the packets that never arrive. 0.01 is a usual WiFi; at 1 the connection is cut.")]
        float _loss = 0.01f;

        [Header("Control clock")]
        [SerializeField, Range(-1000, 1000), Tooltip("What the control clock is ahead of the headset's at the start, s. Changed while playing, "
            + "the clock steps, as after a restart of the controller.")]
        float _clockAheadSeconds = 100;

        [SerializeField, Range(-500, 500), Tooltip("How much faster the control clock runs, ppm. 37 is a usual difference of two quartzes.")]
        float _skewPpm = 37;

        [Header("Chance")]
        [SerializeField, Tooltip("Seed of all delays and losses, read when the simulation begins: the same seed, the same delays.")]
        int _seed = 1;

        IHeadsetClock _time;
        VirtualClock _clock;
        VirtualCell _cell;
        CompensationSession _described;

        /// <summary>The session that receives the data.</summary>
        public MrilSession Session => _session;

        /// <summary>The simulated robot; null while this component is not enabled.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>Gets the true joint positions of the robot at a time.</summary>
        /// <param name="joints">One per moving joint of the robot, rad or m.</param>
        /// <returns>False if the simulation has not begun.</returns>
        public bool TryGetTruth(HeadsetTime at, Span<double> joints)
        {
            if (_cell == null) return false;
            _cell.TruthAt(at, joints);
            return true;
        }

        void OnEnable()
        {
            try
            {
                if (_session == null) throw new InputException("control system '" + name + "' has no session to feed; assign one");
                if (_robot == null) throw new InputException("control system '" + name + "' has no robot to move; assign one");
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
            _cell.Run(now, session);
        }

        void Begin(HeadsetTime now)
        {
            _time = _session.HeadsetClock;
            _clock = new VirtualClock(now, ClockAhead, _skewPpm * 1e-6);
            _cell = new VirtualCell(new PickAndPlaceMotion(Robot), _clock, Knobs(), _seed, now);
        }

        // TimeSpan.FromSeconds rounds to whole milliseconds in Unity.
        TimeSpan ClockAhead => TimeSpan.FromTicks((long)((double)_clockAheadSeconds * TimeSpan.TicksPerSecond));

        VirtualCellSettings Knobs() => new VirtualCellSettings(
            _samplingMs, _latencyMinMs, Mathf.Max(_latencyMinMs, _latencyMaxMs), _jitterMs, _loss, NetworkProfile.All[(int)_network]);
    }
}
