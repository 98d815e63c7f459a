using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using Nowpose.Latency.Profile;
using Nowpose.Session;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Calibrates L_visu by eye: while the robot moves to and fro at constant speed, shift the displayed one along its way until
    /// both agree, and mark that, forward and backward.
    /// </summary>
    /// <remarks>
    /// Half the difference of the two shifts over the speed is the error of L_visu; half their sum is how far the base is
    /// misplaced. For those without a camera: exact to some ms, see <see cref="NudgeCalibration"/>.
    /// </remarks>
    [AddComponentMenu("Nowpose/Latency Nudge")]
    [DisallowMultipleComponent]
    public sealed class LatencyNudge : MonoBehaviour
    {
        const float GreatestOffsetMm = 500;

        [SerializeField, Tooltip("The session that is calibrated. Empty: the one on this object or above.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The rig that is shifted. Empty: the first below the session that shows the displayed pose.")]
        RobotRig _rig = null;

        [SerializeField, Tooltip("What keeps the result on the device. Empty: the one on the session's object; where there is none, the result "
            + "lasts as long as the session.")]
        LatencyProfileLoader _loader = null;

        [SerializeField, Tooltip("The axis of the robot's base frame along which it moves and is shifted: x forward, y left, z up.")]
        NudgeAxis _axis = NudgeAxis.X;

        readonly AxisSpeed _speed = new AxisSpeed();
        MrilSession _source;
        MarkedNudges _marks;
        TimeSpan _told;
        Transform _moved;
        Vector3 _home;
        float _offsetMm;

        /// <summary>By how much the displayed robot is shifted along the axis, mm: −500 to 500. For a slider.</summary>
        public float OffsetMm
        {
            get => _offsetMm;
            set
            {
                _offsetMm = float.IsNaN(value) ? 0 : Mathf.Clamp(value, -GreatestOffsetMm, GreatestOffsetMm);
                Shift();
            }
        }

        /// <summary>Another one ends what was marked.</summary>
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

        /// <summary>Of the displayed tool along the axis, negative backward; null while it is not known.</summary>
        public double? SpeedMmPerS => _speed.MmPerS;

        /// <summary>Whether the tool moves steadily: only then a mark means anything.</summary>
        public bool IsSteady => _speed.IsConstant;

        public int ForwardCount => _marks?.ForwardCount ?? 0;

        public int BackwardCount => _marks?.BackwardCount ?? 0;

        /// <summary>Why the last mark or result was refused, in one line; null when it was not.</summary>
        public string Problem { get; private set; }

        /// <summary>What the last result was, in one line; null before the first.</summary>
        public string Report { get; private set; }

        /// <summary>Shifts by a little more. For buttons.</summary>
        public void Step(float mm) => OffsetMm += mm;

        /// <summary>Displayed and real robot agree now. Which direction it is, the speed tells.</summary>
        /// <returns>Whether it was marked; <see cref="Problem"/> says why not.</returns>
        public bool Mark() => Try(() =>
        {
            var session = NudgedSession();
            if (!(_speed.MmPerS is double speed) || !_speed.IsConstant)
                throw new InputException("nudge: the tool does not move steadily; mark while it moves at constant speed");
            // Marks that were made with another L_visu say something else.
            if (_marks == null || session.Visualisation.Length != _told)
            {
                _told = session.Visualisation.Length;
                _marks = new MarkedNudges(_told.TotalMilliseconds);
            }
            _marks.Add(_offsetMm, speed);
        });

        /// <summary>Forgets all marks.</summary>
        public void Clear()
        {
            _marks?.Clear();
            _speed.Reset();
            Problem = null;
        }

        /// <summary>
        /// Calibrates the session by the marks, keeps that as a profile, and takes the shift back. A render-time limit that was
        /// known stays.
        /// </summary>
        /// <returns>Whether it was kept; <see cref="Problem"/> says why not. Where it only cannot be saved it is used all the same.</returns>
        public bool Apply() => Try(() =>
        {
            var session = NudgedSession();
            var result = (_marks ?? new MarkedNudges(0)).Result;
            var profile = ProfileOf(result, session);
            var isKept = _loader == null || _loader.Save(profile);
            session.Calibrate(profile);
            Report = string.Format(
                CultureInfo.InvariantCulture, "nudge: L_visu {0:0.0} ms ± {1:0.0} ms by {2} marks; the base is misplaced by {3:0.0} mm along {4}",
                result.Visualisation.Length.TotalMilliseconds, result.Spread.TotalMilliseconds, result.Count, result.OffsetMm, _axis);
            ConsoleLog.Say(this, Report);
            Clear();
            // It is in use now, kept or not: with the shift the robot would be corrected twice.
            OffsetMm = 0;
            if (!isKept) throw new InputException(_loader.Problem);
        });

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (_source == null)
            {
                ConsoleLog.Warn(this, "latency nudge '" + name + "' has no session above it to calibrate; assign one");
                return;
            }
            if (_loader == null) _loader = _source.GetComponent<LatencyProfileLoader>();
            var rig = _rig != null ? _rig : DisplayedBelow(_source);
            if (rig == null) ConsoleLog.Warn(this, "latency nudge '" + name + "' finds no rig below the session to shift; assign one");
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
            if (session == null) throw new InputException("nudge: there is no session to calibrate");
            // The robot is drawn with what is predicted: the constant changes nothing that an eye could see.
            if (session.Statistics(default).IsLightPredicted)
                throw new InputException("nudge: the runtime predicts display times; there is nothing to nudge");
            return session;
        }

        // What limits the render time has nothing to do with how it was found how late light is.
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
