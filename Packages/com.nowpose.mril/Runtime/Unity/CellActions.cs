using System;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Provides the wearer's actions on a robot cell as methods. The buttons, toggles, sliders and voice commands of any user interface can
    /// call them.
    /// </summary>
    /// <remarks>
    /// Add one component per session. Except the base anchor, fields that are not assigned are filled with the first suitable object below the session. A
    /// user interface can use <see cref="Changed"/> to update what it shows.
    /// </remarks>
    [AddComponentMenu("Nowpose/Cell Actions")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder - 1)]
    [DisallowMultipleComponent]
    public sealed class CellActions : MonoBehaviour
    {
        [SerializeField, Tooltip("The session of the cell. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The base that is locked. Empty: all Base Anchors below the session.")]
        BaseAnchor _anchor = null;

        [SerializeField, Tooltip("A ghost to show and hide in addition to those in the scene of the session, such as one in another scene.")]
        Ghost _ghost = null;

        [SerializeField, Tooltip("Sets the opacity of the displayed robot and its gripper. Empty: the first one on a rig below the session that "
            + "shows the displayed pose, or else the first one that does not belong to an object or a ghost.")]
        PoseAppearance _appearance = null;

        [SerializeField, Tooltip("The panel that the actions show and hide. Empty: the first panel below the session.")]
        StatusPanel _panel = null;

        [SerializeField, Tooltip("The pairing that asks before it removes the cell. Empty: the first pairing below the session.")]
        CellPairing _pairing = null;

        [SerializeField, Tooltip("Material of the parts that hide objects behind the real arm. Empty: the arm material of the displayed rig.")]
        Material _occluder = null;

        readonly Listeners<Action> _changed = new Listeners<Action>();
        readonly VisualisationNudge _nudge = new VisualisationNudge();
        readonly Occlusion _occlusion = new Occlusion();
        readonly CellGhosts _ghosts = new CellGhosts();
        MrilSession _source;
        (bool, bool, bool, bool, float, float, bool) _lastRaised;

        /// <summary>Raised when one or more properties of this class have changed; at most once per frame.</summary>
        public event Action Changed { add => _changed.Add(value); remove => _changed.Remove(value); }

        /// <summary>Whether a connection is requested. It may not be established yet; the status panel shows its state.</summary>
        public bool IsConnecting => Session is MrilSession session && session.IsConnecting;

        /// <summary>Whether any ghost of the session is shown, of a robot or of an object.</summary>
        public bool IsGhostShown => _ghosts.IsAnyShown;

        /// <summary>Whether the real arm hides virtual objects behind it.</summary>
        public bool IsOcclusionOn => _occlusion.IsOn;

        public bool IsPanelShown => _panel != null && _panel.gameObject.activeSelf;

        /// <summary>Opacity of the displayed robot and its gripper, 0 to 1, as in <see cref="PoseAppearance.Opacity"/>.</summary>
        public float Opacity => _appearance != null ? _appearance.Opacity : 1;

        /// <summary>Offset added to the calibrated L_visu, in ms.</summary>
        public float NudgeMs => (float)_nudge.Ms;

        /// <summary>Whether the nudge has no effect, because the runtime predicts the display times.</summary>
        public bool IsNudgeIdle => _nudge.IsIdle;

        /// <summary>Connects to the gateway.</summary>
        public void Connect()
        {
            if (Has(Session, "session")) Session.Connect();
        }

        /// <summary>Disconnects from the gateway. The robot holds its last pose and is shown as not current.</summary>
        public void Disconnect()
        {
            if (Has(Session, "session")) Session.Disconnect();
        }

        public void ToggleConnected()
        {
            if (IsConnecting) Disconnect();
            else Connect();
        }

        /// <summary>
        /// Starts a new search for the bases of the robots by their markers, or only for the assigned base. Without markers, confirms a base that is
        /// not confirmed.
        /// </summary>
        public void LockBase()
        {
            var session = Session;
            var bases = _anchor != null || session == null ? new[] { _anchor } : session.GetComponentsInChildren<BaseAnchor>(true);
            if (Has(bases.Length > 0 ? bases[0] : null, "base anchor"))
                foreach (var each in bases) each.Relock();
        }

        /// <summary>
        /// Asks the wearer whether to forget the cell in use. The pairing shows this question in the same way as its other questions.
        /// </summary>
        public void ForgetCell()
        {
            FindParts();
            if (Has(_pairing, "cell pairing")) _pairing.AskToForget();
        }

        /// <summary>Hides all ghosts of the session if any is shown; otherwise shows all.</summary>
        public void ToggleGhost()
        {
            FindGhosts();
            SetGhost(!IsGhostShown);
        }

        /// <summary>Shows or hides all ghosts of the session: those of its robots, and tracked objects that show the newest pose.</summary>
        public void SetGhost(bool shown)
        {
            FindGhosts();
            if (_ghosts.Count == 0) Has(null, "ghost");
            _ghosts.Set(shown);
        }

        public void ToggleOcclusion() => SetOcclusion(!IsOcclusionOn);

        /// <summary>Enables or disables occlusion. If disabled, the whole gripper is drawn, including parts behind the real arm.</summary>
        public void SetOcclusion(bool on) => _occlusion.Set(on);

        public void TogglePanel()
        {
            FindParts();
            SetPanel(!IsPanelShown);
        }

        public void SetPanel(bool shown)
        {
            FindParts();
            if (Has(_panel, "status panel")) _panel.gameObject.SetActive(shown);
        }

        /// <summary>
        /// Sets the opacity. A slider can call this method. At 1 the robot has its full opacity, at 0 a fifth of it. A pose that is not current keeps
        /// a minimum visibility.
        /// </summary>
        public void SetOpacity(float opacity)
        {
            FindParts();
            if (!Has(_appearance, "pose appearance")) return;
            _appearance.Opacity = opacity;
            foreach (var gripper in _appearance.GetComponentsInChildren<VirtualGripper>(true))
                if (gripper.TryGetComponent<PoseAppearance>(out var own)) own.Opacity = opacity;
        }

        /// <summary>Adds a difference to the opacity. A button can call this method. A negative difference makes the robot fainter.</summary>
        public void ChangeOpacity(float by)
        {
            FindParts();
            SetOpacity(Opacity + by);
        }

        /// <summary>
        /// Sets <see cref="NudgeMs"/>, −50 to 50 ms. A slider can call this method. A positive value predicts further ahead. A new calibration resets
        /// it to 0.
        /// </summary>
        public void SetNudgeMs(float ms) => _nudge.Ms = ms;

        /// <summary>Adds a difference in ms to <see cref="NudgeMs"/>. A button can call this method.</summary>
        public void ChangeNudgeMs(float by) => SetNudgeMs(NudgeMs + by);

        /// <summary>
        /// Sets the shift of the displayed robot for the calibration by eye, in mm. A slider can call this method. Like the other actions of the
        /// calibration, it switches the <see cref="LatencyNudge"/> of the session on.
        /// </summary>
        public void SetShiftMm(float mm)
        {
            if (Calibration is LatencyNudge calibration) calibration.OffsetMm = mm;
        }

        /// <summary>Adds a difference in mm to the shift for the calibration by eye. A button can call this method.</summary>
        public void ChangeShiftMm(float by)
        {
            if (Calibration is LatencyNudge calibration) calibration.Step(by);
        }

        /// <summary>Sets a mark of the calibration by eye. The status panel shows the number of marks, or why the mark was refused.</summary>
        public void AddMark() => Calibration?.Mark();

        /// <summary>Calibrates the session with the marks, as <see cref="LatencyNudge.Apply"/> does. The status panel shows the result.</summary>
        public void ApplyMarks() => Calibration?.Apply();

        /// <summary>Deletes all marks of the calibration by eye. If there are none, ends the shift.</summary>
        public void ClearMarks()
        {
            if (!(Calibration is LatencyNudge calibration)) return;
            if (calibration.ForwardCount + calibration.BackwardCount == 0) calibration.OffsetMm = 0;
            calibration.Clear();
        }

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (!Has(_source, "session")) return;
            FindParts();
            _occlusion.Begin(_source, _occluder);
            _lastRaised = State;
        }

        // A player may refuse to search the whole scene in OnEnable, while it still loads the scene.
        void Start() => FindGhosts();

        void OnDisable()
        {
            if (_source is object) _occlusion.End();
            _source = null;
        }

        // Runs before the session computes its frame, and after a restarted session has received its calibration.
        void LateUpdate()
        {
            if (_source == null) return;
            _nudge.Follow(_source.Session);
            var state = State;
            if (state == _lastRaised) return;
            _lastRaised = state;
            _changed.Raise(this);
        }

        (bool, bool, bool, bool, float, float, bool) State =>
            (IsConnecting, IsGhostShown, IsOcclusionOn, IsPanelShown, Opacity, NudgeMs, IsNudgeIdle);

        // A user interface may call the actions while this component is disabled.
        MrilSession Session => _source != null ? _source : this.SessionOr(_session);

        // The component is switched off in the prefabs. Null, not a destroyed object, if the session has none.
        LatencyNudge Calibration
        {
            get
            {
                var found = Session is MrilSession session ? session.GetComponentInChildren<LatencyNudge>(true) : null;
                if (found != null)
                {
                    found.enabled = true;
                    return found;
                }
                ConsoleLog.Warn(this, ComponentMessages.NoCalibration(name));
                return null;
            }
        }

        // The actions also call this method, because they may run before this component is first enabled.
        void FindParts()
        {
            var session = Session;
            if (session == null) return;
            if (_panel == null) _panel = session.GetComponentInChildren<StatusPanel>(true);
            if (_pairing == null) _pairing = session.GetComponentInChildren<CellPairing>(true);
            if (_appearance == null) _appearance = DisplayedBelow(session);
        }

        // Ghosts may have been added since the last call.
        void FindGhosts() => _ghosts.Find(Session, _ghost);

        static PoseAppearance DisplayedBelow(MrilSession session)
        {
            PoseAppearance other = null;
            foreach (var appearance in session.GetComponentsInChildren<PoseAppearance>(true))
            {
                if (appearance.GetComponentInParent<Ghost>(true) != null || appearance.TryGetComponent<ICellObject>(out _)) continue;
                if (appearance.TryGetComponent<RobotRig>(out var rig) && rig.Shows == RigPose.Displayed) return appearance;
                if (other == null) other = appearance;
            }
            return other;
        }

        bool Has(UnityEngine.Object needed, string kind)
        {
            if (needed != null) return true;
            ConsoleLog.Warn(this, ComponentMessages.NoAction(name, kind));
            return false;
        }
    }
}
