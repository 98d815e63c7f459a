using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using Nowpose.Latency.Profile;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Calibrates L_visu by eye: while the robot moves back and forth at constant speed, the user shifts the displayed robot along its path
    /// until both agree, and marks the shift, forward and backward.
    /// </summary>
    /// <remarks>
    /// Half the difference of the two shifts divided by the speed is the error of L_visu; half their sum is the error of the base
    /// position. For users without a camera: accurate to some ms, see <see cref="NudgeCalibration"/>.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Nudge")]
    [DisallowMultipleComponent]
    public sealed class LatencyNudge : MonoBehaviour
    {
        const float MaxOffsetMm = 500;

        [SerializeField, Tooltip("The session to calibrate. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The rig to shift. Empty: the first rig below the session that shows the displayed pose.")]
        RobotRig _rig = null;

        [SerializeField, Tooltip("The loader that stores the result on the device. Empty: the loader on the session's object; without one, the "
            + "result is lost when the session ends.")]
        LatencyProfileLoader _loader = null;

        [SerializeField, Tooltip("The axis of the robot's base frame along which the robot moves and the rig is shifted: x forward, y left, z "
            + "up.")]
        NudgeAxis _axis = NudgeAxis.X;

        readonly AxisSpeed _speed = new AxisSpeed();
        MrilSession _source;
        MarkedNudges _marks;
        TimeSpan _usedVisu;
        Transform _moved;
        Vector3 _home;
        float _offsetMm;

        /// <summary>Shift of the displayed robot along the axis, in mm: −500 to 500. For a slider.</summary>
        public float OffsetMm
        {
            get => _offsetMm;
            set
            {
                _offsetMm = float.IsNaN(value) ? 0 : Mathf.Clamp(value, -MaxOffsetMm, MaxOffsetMm);
                Shift();
            }
        }

        /// <summary>Axis of the shift; a change discards the marks.</summary>
        public NudgeAxis Axis
        {
            get => _axis;
            set
            {
                _axis = value;
                Clear();
                Shift();
            }
        }

        /// <summary>Speed of the displayed tool along the axis in mm/s, negative backward; null while it is unknown.</summary>
        public double? SpeedMmPerS => _speed.MmPerS;

        /// <summary>Whether the tool moves at constant speed, which a mark requires.</summary>
        public bool IsSteady => _speed.IsConstant;

        public int ForwardCount => _marks?.ForwardCount ?? 0;

        public int BackwardCount => _marks?.BackwardCount ?? 0;

        /// <summary>Why the last mark or result was rejected, in one line; null if it was not.</summary>
        public string Problem { get; private set; }

        /// <summary>Description of the last result, in one line; null before the first.</summary>
        public string Report { get; private set; }

        /// <summary>Changes the shift by a difference, in mm. For buttons.</summary>
        public void Step(float mm) => OffsetMm += mm;

        /// <summary>Marks that displayed and real robot agree now. The sign of the speed gives the direction.</summary>
        /// <returns>Whether the mark was accepted; otherwise <see cref="Problem"/> gives the reason.</returns>
        public bool Mark() => Try(() =>
        {
            var session = NudgedSession();
            if (!(_speed.MmPerS is double speed) || !_speed.IsConstant)
                throw new InputException(NudgeReports.NotSteady);
            // Marks with another L_visu cannot be combined.
            if (_marks == null || session.Visualisation.Length != _usedVisu)
            {
                _usedVisu = session.Visualisation.Length;
                _marks = new MarkedNudges(_usedVisu.TotalMilliseconds);
            }
            _marks.Add(_offsetMm, speed);
        });

        /// <summary>Discards all marks.</summary>
        public void Clear()
        {
            _marks?.Clear();
            _speed.Reset();
            Problem = null;
        }

        /// <summary>
        /// Calibrates the session from the marks, saves the result as a profile, and resets the shift. Keeps a known
        /// render-time limit.
        /// </summary>
        /// <returns>Whether it was saved; otherwise <see cref="Problem"/> gives the reason. An unsaved result is still used.</returns>
        public bool Apply() => Try(() =>
        {
            var session = NudgedSession();
            var result = (_marks ?? new MarkedNudges(0)).Result;
            var profile = ProfileOf(result, session);
            var isKept = _loader == null || _loader.Save(profile);
            session.Calibrate(profile);
            Report = NudgeReports.Result(result.Visualisation.Length.TotalMilliseconds, result.Spread.TotalMilliseconds, result.Count, result.OffsetMm, _axis);
            ConsoleLog.Info(this, Report);
            Clear();
            // The result is in use, saved or not: the shift would correct the robot twice.
            OffsetMm = 0;
            if (!isKept) throw new InputException(_loader.Problem);
        });

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "latency nudge");
            if (_source == null) return;
            if (_loader == null) _loader = _source.GetComponent<LatencyProfileLoader>();
            var rig = _rig != null ? _rig : DisplayedBelow(_source);
            if (rig == null) ConsoleLog.Warn(this, ComponentMessages.NudgeWithoutRig(name));
            else
            {
                _moved = rig.transform;
                _home = _moved.localPosition;
            }
            _source.Shown += Follow;
            Shift();
        }

        void OnDisable()
        {
            if (_source is null) return;
            _source.Shown -= Follow;
            _source = null;
            if (_moved != null) _moved.localPosition = _home;
            _moved = null;
            _speed.Reset();
        }

        void Follow(DisplayFrame frame)
        {
            if (frame.State == PoseState.Current && frame.DisplayTime.HasValue) _speed.Add(frame.DisplayTime.Value, AlongMm(frame.ToolPose));
            else _speed.Reset();
        }

        double AlongMm(in RigidTransform tool)
        {
            switch (_axis)
            {
                case NudgeAxis.X: return 1000 * tool.X;
                case NudgeAxis.Y: return 1000 * tool.Y;
                default: return 1000 * tool.Z;
            }
        }

        void Shift()
        {
            if (_moved == null) return;
            var metres = _offsetMm / 1000.0;
            var shift = UnityFrame.DirectionToUnity((
                _axis == NudgeAxis.X ? metres : 0, _axis == NudgeAxis.Y ? metres : 0, _axis == NudgeAxis.Z ? metres : 0)).Vector();
            _moved.localPosition = _home + _moved.localRotation * shift;
        }

        CompensationSession NudgedSession()
        {
            var session = _source != null ? _source.Session : null;
            if (session == null) throw new InputException(NudgeReports.NoSession);
            // The robot is drawn with the predicted display time, so the constant has no visible effect.
            if (session.Statistics(default).IsLightPredicted)
                throw new InputException(NudgeReports.Predicted);
            return session;
        }

        // The render-time limit is independent of the method that measured L_visu.
        static LatencyProfile ProfileOf(in NudgeResult result, CompensationSession session)
        {
            var range = session.Range;
            var source = range?.Source ?? RenderTimeSourceKind.None;
            var seenTo = session.Profile?.RenderTimeSource == source ? session.Profile.ValidToRenderTime : null;
            if (range?.IsLimitReached == false) seenTo = range.Limit;
            return new LatencyProfile(
                result.Visualisation.Length.TotalMilliseconds, result.Spread.TotalMilliseconds, session.Conditions, DateTime.UtcNow,
                CalibrationMethod.Nudge, result.Count, range?.IsLimitReached == true ? range.Limit.TotalMilliseconds : (double?)null, source,
                seenTo?.TotalMilliseconds, session.Profile?.HeadMotion);
        }

        static RobotRig DisplayedBelow(MrilSession session)
        {
            foreach (var rig in session.GetComponentsInChildren<RobotRig>(true))
                if (rig.Shows == RigPose.Displayed) return rig;
            return null;
        }

        bool Try(Action action)
        {
            Problem = null;
            try
            {
                action();
                return true;
            }
            catch (InputException fault)
            {
                Problem = fault.Message;
                ConsoleLog.Warn(this, Problem);
                return false;
            }
        }
    }
}
