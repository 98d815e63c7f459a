using Nowpose.Frames;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Shows an object of the cell where it is at the display time, by the name of its frame on /tf or /tf_static.</summary>
    /// <remarks>
    /// The Base Anchor above this object is the frame <c>world</c>; without one, the session's object is. An object whose parent is a link of a
    /// robot moves exactly with the displayed robot. Its <see cref="PoseAppearance"/> shows the state of this object, not that of the robot.
    /// </remarks>
    [AddComponentMenu("Nowpose/Tracked Object")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(PoseAppearance))]
    public sealed class TrackedObject : MonoBehaviour, IShownPart
    {
        [SerializeField, Tooltip("The session that receives the object. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the frame, the child_frame_id of /tf or /tf_static. Empty: the name of this object.")]
        string _frame = "";

        MrilSession _source;
        Transform _world;
        CompensationSession _followed;
        CellFrame _shown;
        string _title;

        /// <summary>Name of the frame.</summary>
        public string Frame => string.IsNullOrEmpty(_frame) ? name : _frame;

        /// <summary>Name of the frame in which the displayed pose is given, such as a robot's link; null while no pose is known.</summary>
        public string Parent => _shown?.Parent;

        /// <summary>Whether the object is shown where it is at the display time, and otherwise why not.</summary>
        public PoseState State => _followed == null ? PoseState.Incomplete : _followed.Frames.StateOf(_shown);

        string IShownPart.Title => _title;

        string IShownPart.Fault
        {
            get
            {
                switch (State)
                {
                    case PoseState.Current: return null;
                    case PoseState.Incomplete: return _shown == null ? "no pose received" : "its parent is unknown";
                    case PoseState.Held: return "its poses have stopped";
                    default: return PoseWords.Of(State);
                }
            }
        }

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (_source == null)
            {
                ConsoleLog.Warn(this, "tracked object '" + name + "' has no session on its object or a parent; assign one");
                return;
            }
            _world = CellPlace.WorldOf(this, _source);
            _source.Shown += Show;
            _title = "object " + Frame;
            _source.Parts.Add(this);
        }

        void OnDisable()
        {
            if (_source is null) return;
            _source.Shown -= Show;
            _source.Parts.Remove(this);
            _source = null;
            _followed = null;
            _shown = null;
        }

        void Show(DisplayFrame frame)
        {
            var session = _source.Session;
            if (session != _followed)
            {
                _followed = session;
                _shown = null;
                session.Frames.Need(Frame);
            }
            _shown ??= session.Frames.Find(Frame);
            if (_shown == null || State == PoseState.Incomplete) return;
            transform.PlaceIn(_world, _shown.World);
        }
    }
}
