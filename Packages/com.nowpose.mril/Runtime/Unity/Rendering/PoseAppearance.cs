using System.Collections.Generic;
using Nowpose.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Makes a pose that is not current look different: everything below this object is fainter and striped, and words say
    /// why. Before the first joint positions nothing is drawn but the words.
    /// </summary>
    /// <remarks>
    /// Sets <c>_Fade</c> (0 to 1) and <c>_Hatch</c> (0 or 1) of the materials' shaders, which the package's have, by property
    /// blocks: the materials stay as they are.
    /// </remarks>
    [AddComponentMenu("Nowpose/Pose Appearance")]
    [DefaultExecutionOrder(MrilSession.ExecutionOrder + 1)]
    [DisallowMultipleComponent]
    public sealed class PoseAppearance : MonoBehaviour
    {
        static readonly int FadeId = Shader.PropertyToID("_Fade");
        static readonly int HatchId = Shader.PropertyToID("_Hatch");

        [SerializeField, Tooltip("The session whose pose is shown. Empty: the one on this object or above.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Where the words are written. They turn to the viewer, and are as large as it takes to read them. Empty: no words.")]
        TextMesh _words = null;

        readonly List<Renderer> _renderers = new List<Renderer>();
        MrilSession _source;
        RobotRig _rig;
        MaterialPropertyBlock _block;
        ReadingDistance _distance;
        PoseState? _pose;
        bool _isMoved, _wasDrawn, _hasWords;

        internal PoseLook Look => !_pose.HasValue ? PoseLook.Abandoned : _isMoved ? PoseLook.Of(_pose.Value) : PoseLook.Unmoved;

        internal bool IsDrawn => _wasDrawn;

        /// <summary>Renderers that take part, the words' apart.</summary>
        internal int PartCount => _renderers.Count;

        /// <summary>Takes up renderers that have come or gone below this object; done by itself when a rig is built.</summary>
        public void Refresh()
        {
            // Not enabled yet, as in an editor's scene: it does so itself then.
            if (_block == null) return;
            GetComponentsInChildren(true, _renderers);
            if (_words != null) _renderers.Remove(_words.GetComponent<Renderer>());
            Draw();
        }

        void OnEnable()
        {
            _block ??= new MaterialPropertyBlock();
            _pose = PoseState.Incomplete;
            _isMoved = true;
            _source = _session != null ? _session : GetComponentInParent<MrilSession>();
            _rig = GetComponentInParent<RobotRig>();
            if (_rig != null) _rig.Bound += Refresh;
            if (_source != null)
            {
                _source.Shown += Show;
                _source.Hidden += Abandon;
                if (_source.Frame != null) _pose = _source.Frame.State;
            }
            else Debug.LogWarning("[Nowpose] pose appearance '" + name + "' has no session above it to follow; assign one", this);
            Refresh();
        }

        void OnDisable()
        {
            if (_rig is object) _rig.Bound -= Refresh;
            if (_source is object)
            {
                _source.Shown -= Show;
                _source.Hidden -= Abandon;
            }
            _pose = PoseState.Current;
            _isMoved = true;
            Draw();
        }

        void LateUpdate()
        {
            if (!_hasWords || _words == null) return;
            var viewer = Viewer.Head;
            if (viewer != null) _distance.Face(_words, viewer.position);
        }

        void Show(DisplayFrame frame)
        {
            var isMoved = _rig == null || _rig.IsFollowing;
            if (frame.State == _pose && isMoved == _isMoved) return;
            _pose = frame.State;
            _isMoved = isMoved;
            Draw();
        }

        void Abandon()
        {
            _pose = null;
            Draw();
        }

        void Draw()
        {
            var look = Look;
            // What was not drawn before the session ended does not come to light by that.
            if (_pose.HasValue) _wasDrawn = look.IsDrawn;
            foreach (var each in _renderers)
                if (each != null) Draw(each, look);
            _hasWords = _words != null && look.Words.Length > 0;
            if (_words != null) _words.text = look.Words;
        }

        void Draw(Renderer target, in PoseLook look)
        {
            target.forceRenderingOff = !_wasDrawn;
            target.GetPropertyBlock(_block);
            _block.SetFloat(FadeId, look.Fade);
            _block.SetFloat(HatchId, look.IsHatched ? 1 : 0);
            target.SetPropertyBlock(_block);
        }
    }
}
