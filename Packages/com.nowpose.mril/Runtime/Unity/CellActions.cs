using System;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// What a wearer can do with a robot cell, as methods that a button, toggle, slider or voice command of any user interface
    /// can call.
    /// </summary>
    /// <remarks>
    /// One for each session. What it acts on is looked for below the session unless assigned. <see cref="Changed"/> tells a user
    /// interface when to show another state, whoever brought it about.
    /// </remarks>
    [AddComponentMenu("Nowpose/Cell Actions")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder - 1)]
    [DisallowMultipleComponent]
    public sealed class CellActions : MonoBehaviour
    {
        [SerializeField, Tooltip("The session of the cell. Empty: the one on this object or above.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Where the robot's base is. Empty: the first below the session.")]
        BaseAnchor _anchor = null;

        [SerializeField, Tooltip("What shows the uncompensated pose. Empty: the first below the session.")]
        Ghost _ghost = null;

        [SerializeField, Tooltip("What makes the displayed robot and its gripper fainter. Empty: the first below the session that is no ghost's.")]
        PoseAppearance _appearance = null;

        [SerializeField, Tooltip("The panel that is shown and hidden. Empty: the first below the session.")]
        StatusPanel _panel = null;

        [SerializeField, Tooltip("What knows the cell and asks before it forgets it. Empty: the first below the session.")]
        CellPairing _pairing = null;

        [SerializeField, Tooltip("Material of the parts that hide what is behind the real arm. Empty: the arm material of the displayed rig.")]
        Material _occluder = null;

        readonly VisualisationNudge _nudge = new VisualisationNudge();
        readonly Occlusion _occlusion = new Occlusion();
        MrilSession _source;
        CellState _told;

        /// <summary>One of the properties of this class is another one than before; at most once a frame.</summary>
        public event Action Changed;

        /// <summary>Whether the session is to be connected; the status panel tells whether it is.</summary>
        public bool IsConnecting => _source != null && _source.IsConnecting;

        public bool IsGhostShown => _ghost != null && _ghost.Visible;

        /// <summary>Whether what is behind the real arm is hidden.</summary>
        public bool IsOcclusionOn => _occlusion.IsOn;

        public bool IsPanelShown => _panel != null && _panel.gameObject.activeSelf;

        /// <summary>Of the displayed robot and its gripper, 0 to 1, as <see cref="PoseAppearance.Opacity"/>.</summary>
        public float Opacity => _appearance != null ? _appearance.Opacity : 1;

        /// <summary>What is added to the calibrated L_visu, ms.</summary>
        public float NudgeMs => (float)_nudge.Ms;

        /// <summary>Whether the runtime predicts when light appears: the nudge changes nothing that is seen then.</summary>
        public bool IsNudgeIdle => _nudge.IsIdle;

        /// <summary>Connects to the gateway.</summary>
        public void Connect()
        {
            if (Has(_source, "session")) _source.Connect();
        }

        /// <summary>Leaves the gateway; the pose is held, and said to be.</summary>
        public void Disconnect()
        {
            if (Has(_source, "session")) _source.Disconnect();
        }

        public void ToggleConnected()
        {
            if (IsConnecting) Disconnect();
            else Connect();
        }

        /// <summary>Lets the markers say anew where the base is.</summary>
        public void LockBase()
        {
            if (Has(_anchor, "base anchor")) _anchor.Relock();
        }

        /// <summary>Asks whether to forget the cell in use; the answer is given as to any question of the pairing.</summary>
        public void ForgetCell()
        {
            if (Has(_pairing, "cell pairing")) _pairing.AskToForget();
        }

        public void ToggleGhost() => SetGhost(!IsGhostShown);

        public void SetGhost(bool shown)
        {
            if (Has(_ghost, "ghost")) _ghost.Visible = shown;
        }

        public void ToggleOcclusion() => SetOcclusion(!IsOcclusionOn);

        /// <summary>Off: the whole gripper is drawn, also what is behind the real arm.</summary>
        public void SetOcclusion(bool on) => _occlusion.Set(on);

        public void TogglePanel() => SetPanel(!IsPanelShown);

        public void SetPanel(bool shown)
        {
            if (Has(_panel, "status panel")) _panel.gameObject.SetActive(shown);
        }

        /// <summary>For a slider: 1 is as it is, 0 the fifth that a fade leaves; a pose that is not current stays as visible as it must.</summary>
        public void SetOpacity(float opacity)
        {
            if (Has(_appearance, "pose appearance")) _appearance.Opacity = opacity;
        }

        /// <summary>For a button: fainter (negative) or stronger by that.</summary>
        public void ChangeOpacity(float by) => SetOpacity(Opacity + by);

        /// <summary>For a slider: predicts further ahead (positive) or less far, at most 50 ms; another calibration ends it.</summary>
        public void SetNudgeMs(float ms) => _nudge.Ms = ms;

        /// <summary>For a button: <see cref="SetNudgeMs"/> that much more or less.</summary>
        public void ChangeNudgeMs(float by) => SetNudgeMs(NudgeMs + by);

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (!Has(_source, "session")) return;
            if (_anchor == null) _anchor = _source.GetComponentInChildren<BaseAnchor>(true);
            if (_ghost == null) _ghost = _source.GetComponentInChildren<Ghost>(true);
            if (_panel == null) _panel = _source.GetComponentInChildren<StatusPanel>(true);
            if (_pairing == null) _pairing = _source.GetComponentInChildren<CellPairing>(true);
            if (_appearance == null) _appearance = DisplayedBelow(_source);
            _occlusion.Begin(_source, _occluder);
            _told = State;
        }

        void OnDisable()
        {
            if (_source is object) _occlusion.End();
            _source = null;
        }

        // After what calibrates a session that has begun anew, before the session computes its frame.
        void LateUpdate()
        {
            if (_source == null) return;
            _nudge.Follow(_source.Session);
            var state = State;
            if (state.IsSameAs(_told)) return;
            _told = state;
            Changed?.Invoke();
        }

        CellState State => new CellState(IsConnecting, IsGhostShown, IsOcclusionOn, IsPanelShown, Opacity, NudgeMs, IsNudgeIdle);

        static PoseAppearance DisplayedBelow(MrilSession session)
        {
            foreach (var appearance in session.GetComponentsInChildren<PoseAppearance>(true))
                if (!appearance.TryGetComponent<Ghost>(out _)) return appearance;
            return null;
        }

        bool Has(UnityEngine.Object needed, string kind)
        {
            if (needed != null) return true;
            ConsoleLog.Warn(this, "cell actions '" + name + "' find no " + kind + " to act on; assign one");
            return false;
        }
    }
}
