using System.Collections.Generic;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using Nowpose.Unity.Status;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Shows that the pose of a robot or of an object of the cell is not current, or that the base is uncertain: all parts below this object become
    /// striped and fainter, and a label states the reason. Before the first joint positions arrive, only the label is drawn. The parts of a rig or
    /// gripper that no longer follows the session are hidden. Parts below another Pose Appearance belong to that one.
    /// </summary>
    /// <remarks>
    /// Sets the shader properties <c>_Fade</c> (0 to 1) and <c>_Hatch</c> (0 or 1), which the shaders of the package have, through a property block.
    /// The materials themselves do not change. If a material lacks one of these properties and is blended by its alpha, the component lowers the
    /// alpha. Parts with any other material are drawn with the substitute, or hidden, while the pose is not current. Disabling the component restores
    /// all values.
    /// </remarks>
    [AddComponentMenu("Nowpose/Pose Appearance")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 1)]
    [DisallowMultipleComponent]
    public sealed class PoseAppearance : MonoBehaviour
    {
        [SerializeField, Tooltip("The session whose pose is shown. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Text mesh of the label that shows the state. It turns to face the viewer and keeps a legible size. Empty: no "
            + "label.")]
        TextMesh _words = null;

        [SerializeField, Tooltip("While the pose is not current, this material replaces opaque materials whose shader lacks _Hatch or _Fade. Its own "
            + "shader must have both, as the package's Hologram does. Empty: such parts are hidden instead.")]
        Material _substitute = null;

        readonly PoseMaterials _materials = new PoseMaterials();
        readonly UnsuitableMaterials _unsuitable = new UnsuitableMaterials();
        readonly List<Renderer> _found = new List<Renderer>();
        readonly Dictionary<Renderer, PosePart> _parts = new Dictionary<Renderer, PosePart>();
        readonly List<PoseCarrier> _carriers = new List<PoseCarrier>();
        readonly SignalFaults _signals = new SignalFaults();
        MrilSession _source;
        RobotRig _rig;
        PoseCarrier _carrier;
        MaterialPropertyBlock _block;
        PoseLabel _label;
        PoseState? _pose;
        OutsideRangeResponse _outsideRange;
        BaseAnchor _anchor;
        BaseLook _base;
        bool _isOn, _isUnplaced;
        float _opacity = 1;

        /// <summary>
        /// Opacity of the parts, from 0 (a fifth of the full opacity) to 1 (full). A low value lets the wearer see objects behind the parts. A pose
        /// that is not current stays striped and keeps a minimum visibility.
        /// </summary>
        public float Opacity
        {
            get => _opacity;
            set
            {
                _opacity = float.IsNaN(value) ? 1 : Mathf.Clamp01(value);
                if (_isOn) Draw();
            }
        }

        /// <summary>Material that replaces materials that cannot fade. A new value takes effect at the next <see cref="Refresh"/>.</summary>
        internal Material Substitute { get => _substitute; set => _substitute = value; }

        internal PoseLook Look
        {
            get
            {
                var look = LookOfPose;
                return _pose.HasValue && look.IsDrawn ? WithSignal(look, _signals.First) : look;
            }
        }

        PoseLook LookOfPose
        {
            get
            {
                if (!(_pose is PoseState pose)) return PoseLook.NoSession;
                var look = _base.Over(_isUnplaced ? PoseLook.Unplaced : PoseLook.Of(pose, _outsideRange));
                return look.IsDrawn && Unmoved is PoseCarrier unmoved ? unmoved.Unmoved(look) : look;
            }
        }

        /// <summary>Whether any part is drawn, not counting the label.</summary>
        internal bool IsDrawn
        {
            get
            {
                foreach (var part in _parts.Values)
                    if (part.IsDrawn) return true;
                return false;
            }
        }

        /// <summary>Number of renderers, not counting that of the label.</summary>
        internal int PartCount => _parts.Count;

        /// <summary>Whether a renderer below this object has a material that cannot mark a pose as not current.</summary>
        internal bool NeedsSubstitute
        {
            get
            {
                var materials = new PoseMaterials();
                foreach (var each in GetComponentsInChildren<Renderer>(true))
                    if (this.Owns(each, _words) && materials.Of(materials.In(each)).Means == PoseMeans.None) return true;
                return false;
            }
        }

        /// <summary>
        /// Updates the list of renderers below this object. Call it after renderers were added or removed. The component itself calls it when it is
        /// enabled and when a rig is built.
        /// </summary>
        public void Refresh()
        {
            // While the component is disabled, there is nothing to update: OnEnable reads the list.
            if (!_isOn) return;
            GetComponentsInChildren(true, _found);
            _found.RemoveAll(each => !this.Owns(each, _words));
            Leave();
            _materials.Begin(_substitute);
            _carriers.Clear();
            _signals.Clear();
            _anchor = GetComponentInParent<BaseAnchor>();
            _base = BaseLook.Of(_anchor);
            _carrier = PoseCarrier.Of(transform, _carrier);
            Follow(_carrier);
            foreach (var each in _found)
            {
                if (!_parts.TryGetValue(each, out var part)) _parts.Add(each, part = new PosePart(each, transform, _block, _materials));
                part.Take();
                Follow(part.Carrier);
                _signals.Add(part.Signals);
                if (part.HasUnsuitableMaterial) _unsuitable.Report(this, part.UnsuitableMaterial, each, _materials.Substitute);
            }
            Draw();
        }

        void OnEnable()
        {
            _block ??= new MaterialPropertyBlock();
            _pose = PoseState.Incomplete;
            _rig = GetComponentInParent<RobotRig>();
            if (_rig != null) _rig.Followed += FollowRig;
            _source = Searched;
            // Without a session, a script moves the robot, and its pose has no state.
            if (_source == null && _rig != null) return;
            _isOn = true;
            if (_source == null) this.RequiredSession(null, "pose appearance");
            var above = transform.parent != null ? transform.parent.GetComponentInParent<PoseAppearance>(true) : null;
            if (above != null) above.HandOverTo(this);
            if (_rig != null) _rig.Bound += Refresh;
            if (_source != null)
            {
                _source.Computed += Show;
                _source.Hidden += ShowNoSession;
                if (_source.Frame != null) Take(PlacedState.Of(transform, _source.Frame, _source), _source.Frame);
            }
            Refresh();
        }

        void OnDisable()
        {
            if (_rig is object)
            {
                _rig.Bound -= Refresh;
                _rig.Followed -= FollowRig;
            }
            if (_source is object)
            {
                _source.Computed -= Show;
                _source.Hidden -= ShowNoSession;
            }
            _isOn = false;
            _pose = PoseState.Current;
            _carriers.Clear();
            foreach (var part in _parts.Values) part.Restore();
            _label.Set(_words, "");
        }

        void OnTransformParentChanged()
        {
            if (isActiveAndEnabled) FollowRig();
        }

        // The session of the robot also applies to its parts.
        MrilSession Searched => this.SessionOr(_session != null || _rig == null ? _session : _rig.AssignedSession);

        void FollowRig()
        {
            if (Searched == _source && _rig == GetComponentInParent<RobotRig>()) return;
            OnDisable();
            OnEnable();
        }

        void LateUpdate() => _label.Face(_words);

        void Show(DisplayFrame frame)
        {
            // Another listener may have ended the session.
            if (_source.Session == null) return;
            var placed = PlacedState.Of(transform, frame, _source);
            var hasChanged = placed.Pose != _pose || placed.IsUnplaced != _isUnplaced;
            foreach (var carrier in _carriers) hasChanged |= carrier.HasChanged();
            hasChanged |= _signals.Update();
            var known = BaseLook.Of(_anchor);
            hasChanged |= !known.IsSameAs(_base);
            _base = known;
            if (!hasChanged) return;
            Take(placed, frame);
            Draw();
        }

        void Take(PlacedState placed, DisplayFrame frame)
        {
            (_pose, _isUnplaced) = (placed.Pose, placed.IsUnplaced);
            _outsideRange = frame.OutsideRange;
        }

        void ShowNoSession()
        {
            _pose = null;
            Draw();
        }

        void Draw()
        {
            var look = LookOfPose;
            foreach (var part in _parts.Values)
            {
                if (!_pose.HasValue) part.ShowNoSession(_opacity);
                else part.Draw(WithSignal(look, _signals.Of(part)), _opacity);
            }
            _label.Set(_words, Look.Label);
        }

        // A part whose signal is not current may be at the wrong end of its stroke or in the wrong state, so it is striped like a pose that is not
        // current.
        static PoseLook WithSignal(PoseLook look, (string Label, string Reason) fault) => fault.Reason == null ? look
            : look.Also(fault.Label, fault.Reason, PoseLook.Of(PoseState.Held).Fade);

        /// <summary>The first active carrier (rig before gripper) that does not follow the session; null if all follow.</summary>
        PoseCarrier Unmoved
        {
            get
            {
                foreach (var carrier in _carriers)
                    if (carrier.IsActive && !carrier.IsFollowing) return carrier;
                return null;
            }
        }

        // Restores the parts of an appearance that was added below this one, before that one stores their original look.
        void HandOverTo(PoseAppearance below)
        {
            foreach (var part in _parts.Keys)
            {
                if (part == null || !part.transform.IsChildOf(below.transform)) continue;
                Refresh();
                return;
            }
        }

        void Follow(PoseCarrier carrier)
        {
            if (carrier == null) return;
            foreach (var known in _carriers)
                if (known.IsSameAs(carrier)) return;
            _carriers.Add(carrier);
        }

        // Restores the renderers that are no longer below this object, and removes them from the list.
        void Leave()
        {
            foreach (var known in new List<Renderer>(_parts.Keys))
            {
                if (_found.Contains(known)) continue;
                _parts[known].Restore();
                _parts.Remove(known);
            }
        }
    }
}
