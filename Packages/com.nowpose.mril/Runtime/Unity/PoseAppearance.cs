using System.Collections.Generic;
using Nowpose.Session;
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
    /// gripper that no longer follows the session are hidden. Parts below another enabled Pose Appearance belong to that one.
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
        readonly PartPlaces _places = new PartPlaces();
        readonly List<PoseAppearance> _below = new List<PoseAppearance>();
        readonly PoseCarriers _carriers = new PoseCarriers();
        readonly SignalFaults _signals = new SignalFaults();
        MrilSession _source;
        RobotRig _rig;
        PoseCarrier _carrier;
        MaterialPropertyBlock _block;
        PoseLabel _label;
        DisplayFrame _frame;
        bool _isOn, _isEnded, _isDestroyed;
        int _followedFrame;
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

        /// <summary>The look of the first parts that are not current; if all are, that of a current pose.</summary>
        internal PoseLook Look
        {
            get
            {
                var look = PoseLook.Of(PoseState.Current);
                for (var i = 0; i < _places.Count && look.Label.Length == 0; i++) look = LookOf(_places[i]);
                return !_isEnded && look.IsDrawn ? WithSignal(look, _signals.First) : look;
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

        /// <summary>Whether the component draws the parts that belong to it. Otherwise they belong to the next one above.</summary>
        internal bool IsOwner => enabled && !_isDestroyed;

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
        /// Updates the list of renderers below this object. Call it after renderers were added or removed; after a move, call it first for the former
        /// appearance. It is called when this component is enabled or moved, a rig is built, or a signal, actuated part or gripper is added or moved.
        /// The move of an object that has never been active is not reported to its scripts.
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
            _places.Clear();
            _places.Add(transform, transform, _frame, _source);
            GetComponentsInChildren(true, _below);
            _below.RemoveAll(each => each == this || !each.IsOwner);
            _carrier = PoseCarrier.Of(transform, _carrier);
            _carriers.Add(_carrier);
            foreach (var each in _found)
            {
                if (!_parts.TryGetValue(each, out var part)) _parts.Add(each, part = new PosePart(each, transform, _block, _materials));
                part.Take();
                part.Place = _places.Add(each.transform, transform, _frame, _source);
                _carriers.Add(part.Carrier);
                _signals.Add(part.Signals);
            }
            Draw();
        }

        /// <summary>Sets the field Session, and shows the state of the pose in this session from now on.</summary>
        /// <param name="session">The session; null to use that of the object or rig, or the session on this object or a parent.</param>
        public void Follow(MrilSession session)
        {
            _session = session;
            FindSession();
        }

        void OnEnable()
        {
            _block ??= new MaterialPropertyBlock();
            _isEnded = false;
            _rig = GetComponentInParent<RobotRig>();
            if (_rig != null) _rig.Followed += FindSession;
            _source = Searched;
            // Without a session, a script moves the robot, and its pose has no state.
            if (_source == null && _rig != null) return;
            _isOn = true;
            if (_source == null) this.RequiredSession(null, "pose appearance");
            HandOver();
            if (_rig != null) _rig.Bound += Refresh;
            if (_source != null)
            {
                _source.Computed += Show;
                _source.Hidden += ShowNoSession;
                _frame = _source.Frame;
            }
            Refresh();
        }

        void OnDisable()
        {
            if (_rig is object)
            {
                _rig.Bound -= Refresh;
                _rig.Followed -= FindSession;
            }
            if (_source is object)
            {
                _source.Computed -= Show;
                _source.Hidden -= ShowNoSession;
            }
            (_isOn, _isEnded, _frame) = (false, false, null);
            _places.Clear();
            _carriers.Clear();
            foreach (var part in _parts.Values) part.Restore();
            _label.Set(_words, "");
        }

        // Unity destroys components before it renders the frame, but after all scripts have run.
        void OnDestroy()
        {
            _isDestroyed = true;
            foreach (var other in GetComponentsInParent<PoseAppearance>(true)) other.Refresh();
        }

        void OnTransformParentChanged()
        {
            FindSession();
            if (!_isOn) return;
            HandOver();
            Refresh();
        }

        MrilSession Searched => this.SessionOfParts(_session, _rig);

        /// <summary>Follows the session and rig again if they have changed.</summary>
        internal void FindSession()
        {
            if (!isActiveAndEnabled) return;
            if (Searched == _source && _rig == GetComponentInParent<RobotRig>()) return;
            OnDisable();
            OnEnable();
        }

        void LateUpdate()
        {
            _label.Face(_words);
            _followedFrame = Time.frameCount;
            FollowMaterials();
            // An appearance on an inactive object is disabled or destroyed without a message to its script.
            if (_below.Exists(each => each == null || !each.IsOwner)) Refresh();
        }

        void Show(DisplayFrame frame)
        {
            // Another listener may have ended the session.
            if (_source.Session == null) return;
            if (_places.HasLostMover) Refresh();
            var hasChanged = _isEnded | _places.Update(frame, _source);
            (_frame, _isEnded) = (frame, false);
            hasChanged |= _carriers.Update();
            hasChanged |= _signals.Update();
            if (hasChanged) Draw();
            // Otherwise LateUpdate follows them; it does not run after the computation right before rendering.
            else if (_followedFrame == Time.frameCount) FollowMaterials();
        }

        void ShowNoSession()
        {
            (_frame, _isEnded) = (null, true);
            Draw();
        }

        void Draw()
        {
            foreach (var part in _parts.Values)
            {
                if (_isEnded) part.ShowNoSession(_opacity);
                else part.Draw(WithSignal(LookOf(part.Place), _signals.Of(part)), _opacity);
                _unsuitable.Report(this, part, _materials.Substitute);
            }
            _label.Set(_words, PlacedState.IsUncompensated(transform) ? PoseMessages.OfGhost(Look.Label) : Look.Label);
        }

        // A script or an event may assign another material at any time.
        void FollowMaterials()
        {
            foreach (var part in _parts.Values)
                if (part.FollowMaterials()) _unsuitable.Report(this, part, _materials.Substitute);
        }

        PoseLook LookOf(PartPlace place)
        {
            if (_isEnded) return PoseLook.NoSession;
            var look = place.Base.Over(place.State.IsUnplaced ? PoseLook.Unplaced : PoseLook.Of(place.State.Pose, place.OutsideRange));
            return look.IsDrawn ? _carriers.Over(look) : look;
        }

        // A part whose signal is not current may be at the wrong end of its stroke or in the wrong state, so it is striped like a pose that is not
        // current.
        static PoseLook WithSignal(PoseLook look, (string Label, string Reason) fault) => fault.Reason == null ? look
            : look.Also(fault.Label, fault.Reason, PoseLook.Of(PoseState.Held).Fade);

        // The appearances above restore the parts of one that was added, enabled or moved below them, before it stores their original look.
        void HandOver()
        {
            foreach (var above in GetComponentsInParent<PoseAppearance>(true))
                if (above != this && !above._below.Contains(this)) above.Refresh();
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
