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
    /// Calibrates L_visu by eye. While the robot moves back and forth at constant speed, the user shifts the displayed robot along the path
    /// until it coincides with the real robot, and marks this shift, once for each direction of the motion.
    /// </summary>
    /// <remarks>
    /// The error of L_visu is half the difference of the two shifts, divided by the speed. The error of the base position is half the sum
    /// of the shifts. This method needs no camera. Its error is a few ms; see <see cref="NudgeCalibration"/>.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Nudge")]
    [DisallowMultipleComponent]
    public sealed class LatencyNudge : MonoBehaviour
    {
        const float MaxOffsetMm = 500;

        [SerializeField, Tooltip("The session to calibrate. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The rig to shift. Empty: the first rig below the session that shows the displayed pose of "
            + "the session's own robot.")]
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
        RobotRig _moved;
        NudgeAxis _usedAxis;
        float _offsetMm;

        /// <summary>Shift of the displayed robot along the axis in mm, −500 to 500, for a slider.</summary>
        public float OffsetMm
        {
            get => _offsetMm;
            set
            {
                _offsetMm = float.IsNaN(value) ? 0 : Mathf.Clamp(value, -MaxOffsetMm, MaxOffsetMm);
                Problem = null;
                Shift();
                UpdateProgress();
            }
        }

        /// <summary>Axis of the shift. A change of the axis discards all marks.</summary>
        public NudgeAxis Axis
        {
            get => _axis;
            set
            {
                _axis = value;
                TakeAxis();
            }
        }

        /// <summary>Speed of the displayed tool along the axis in mm/s, negative for backward motion; null while it is unknown.</summary>
        public double? SpeedMmPerS => _speed.MmPerS;

        /// <summary>Whether the tool moves at constant speed. A mark is accepted only then.</summary>
        public bool IsSteady => _speed.IsConstant;

        public int ForwardCount => _marks?.ForwardCount ?? 0;

        public int BackwardCount => _marks?.BackwardCount ?? 0;

        /// <summary>Reason why the last mark or result was rejected, in one line; null if it was accepted.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>Describes the last result in one line; null before the first result.</summary>
        [field: NonSerialized] public string Report { get; private set; }

        /// <summary>Shift and marks, or the result until the next change, for the status panel; null while the calibration is not used.</summary>
        [field: NonSerialized] internal string Progress { get; private set; }

        /// <summary>Adds a length in mm to the shift. A button can call this method.</summary>
        public void Step(float mm) => OffsetMm += mm;

        /// <summary>Records the current shift as a mark. Call this method while the displayed and the real robot coincide.</summary>
        /// <remarks>The sign of the speed determines whether the mark belongs to the forward or to the backward motion.</remarks>
        /// <returns>True if the mark was accepted; otherwise <see cref="Problem"/> gives the reason.</returns>
        public bool Mark() => Try(() =>
        {
            var session = NudgedSession();
            if (!(_speed.MmPerS is double speed) || !_speed.IsConstant)
                throw new InputException(NudgeReports.NotSteady);
            // Marks that were made with different values of L_visu cannot be combined.
            if (_marks == null || session.Visualisation.Length != _usedVisu)
            {
                _usedVisu = session.Visualisation.Length;
                _marks = new MarkedNudges(_usedVisu.TotalMilliseconds);
            }
            _marks.Add(_offsetMm, speed);
            UpdateProgress();
        });

        /// <summary>Discards all marks.</summary>
        public void Clear()
        {
            _marks?.Clear();
            _speed.Reset();
            Problem = null;
            UpdateProgress();
        }

        /// <summary>
        /// Calculates L_visu from the marks, calibrates the session with it, saves it in a profile, and resets the shift. The profile keeps a
        /// known render-time limit.
        /// </summary>
        /// <returns>
        /// True if the profile was saved or no loader exists to save it; otherwise <see cref="Problem"/> gives the reason. The session uses a
        /// result even if it could not be saved.
        /// </returns>
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
            // The session now uses the result, so a remaining shift would correct the displayed robot a second time.
            OffsetMm = 0;
            Progress = Report;
            if (!isKept) throw new InputException(_loader.Problem);
        });

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "latency nudge");
            if (_source == null) return;
            if (_loader == null) _loader = _source.GetComponent<LatencyProfileLoader>();
            _moved = _rig != null ? _rig : DisplayedBelow(_source);
            if (_moved == null) ConsoleLog.Warn(this, ComponentMessages.NudgeWithoutRig(name));
            _source.Computed += Follow;
            TakeAxis();
            Shift();
            UpdateProgress();
        }

        void OnDisable()
        {
            if (_source is null) return;
            _source.Computed -= Follow;
            _source = null;
            if (_moved != null) _moved.Shift = Vector3.zero;
            _moved = null;
            _speed.Reset();
            Progress = null;
        }

        // The Inspector changes the field without the setter.
        void TakeAxis()
        {
            if (_axis == _usedAxis) return;
            _usedAxis = _axis;
            Clear();
            Shift();
        }

        void Follow(DisplayFrame frame)
        {
            TakeAxis();
            // An assigned rig may show a robot in a namespace.
            if (_moved != null && _moved.Robot is SessionRobot robot) frame = robot.Frame;
            // A computation that is not drawn would halve the time over which the speed must be constant.
            if (!frame.IsLast) return;
            if (frame.State == PoseState.Current && frame.DisplayTime.HasValue) _speed.Add(frame.DisplayTime.Value, AlongMm(frame.ToolPose));
            else _speed.Reset();
        }

        void UpdateProgress()
        {
            var isBegun = isActiveAndEnabled && (_offsetMm != 0 || ForwardCount + BackwardCount > 0);
            Progress = isBegun ? NudgeReports.Progress(_offsetMm, _axis, ForwardCount, BackwardCount) : null;
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
            _moved.Shift = UnityFrame.DirectionToUnity((
                _axis == NudgeAxis.X ? metres : 0, _axis == NudgeAxis.Y ? metres : 0, _axis == NudgeAxis.Z ? metres : 0)).Vector();
        }

        CompensationSession NudgedSession()
        {
            if (!isActiveAndEnabled) throw new InputException(NudgeReports.Disabled);
            if (_source == null) throw new InputException(NudgeReports.NoSession);
            var session = _source.Session;
            if (session == null) throw new InputException(NudgeReports.NotRunning);
            // With display times from the runtime, L_visu does not affect the displayed robot.
            if (session.Statistics(default).IsLightPredicted)
                throw new InputException(NudgeReports.Predicted);
            return session;
        }

        // Keeps the render-time limit of the current profile, because it does not depend on how L_visu was measured.
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
                if (rig.Shows == RigPose.Displayed && rig.RobotNamespace.Length == 0) return rig;
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
