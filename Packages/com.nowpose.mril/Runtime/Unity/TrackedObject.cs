using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Shows an object of the cell where it is at the display time. The object's pose is a frame on /tf or /tf_static.</summary>
    /// <remarks>
    /// The frame <c>world</c> is the Base Anchor above this object. If there is none, it is the Base Anchor below the session, or else the session's
    /// object. If the parent of the frame is a link of a robot, the object moves exactly with the displayed robot. The <see cref="PoseAppearance"/>
    /// on this object shows the state of the object, not that of the robot.
    /// </remarks>
    [AddComponentMenu("Nowpose/Tracked Object")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(PoseAppearance))]
    public sealed class TrackedObject : MonoBehaviour, ICellObject, IFollowsSession
    {
        [SerializeField, Tooltip("The session that receives the object. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the frame, the child_frame_id of /tf or /tf_static. Empty: the name of this object.")]
        string _frame = "";

        [SerializeField, Tooltip("Displayed: the object's pose at the time when the light reaches the eye. Held: the newest pose, for comparison.")]
        RigPose _shows = RigPose.Displayed;

        [SerializeField, Tooltip("Whether a Grip by Reach can grip the object. It takes effect when this component is enabled.")]
        bool _canBeGripped = true;

        FollowedFrame _followed;

        /// <summary>Name of the frame.</summary>
        public string Frame => _followed != null ? _followed.Name : string.IsNullOrEmpty(_frame) ? name : _frame;

        public RigPose Shows => _shows;

        /// <summary>Name of the frame in which the displayed pose is given, such as a robot's link; null while no pose is known.</summary>
        public string Parent => _followed?.Parent;

        /// <summary>State of the object's pose. If the object is not shown where it is at the display time, the state gives the reason.</summary>
        public PoseState State => _followed == null ? PoseState.Incomplete : _followed.State;

        /// <summary>Reason why the object's pose is not current, in one line; null if it is current.</summary>
        public string Fault =>
            _followed != null ? _followed.Fault : isActiveAndEnabled ? StatusMessages.NoSession : ObjectMessages.Disabled("tracked object", name);

        /// <summary>
        /// Distance in metres between the newest pose and the pose at the display time: the distance by which the compensation moves the object. Null
        /// while no pose is known.
        /// </summary>
        public float? GapMetres => _followed?.GapMetres;

        MrilSession IFollowsSession.AssignedSession => _session;

        PoseState ICellObject.SettledState => _followed == null ? PoseState.Incomplete : _followed.SettledState;

        Transform ICellObject.World => _followed?.World;

        bool ICellObject.IsUnplaced => false;

        bool ICellObject.IsFixed => _followed != null && _followed.IsFixed;

        internal bool IsOf(MrilSession session) => this.IsOf(_session, session);

        /// <summary>
        /// Sets the fields Session and Frame, and follows the frame from now on. A script can call this method at any time, for example after it has
        /// created the object.
        /// </summary>
        /// <param name="session">The session that receives the object; null to use the session on this object or a parent.</param>
        /// <param name="frame">Name of the frame; empty for the name of this object.</param>
        public void Follow(MrilSession session, string frame = "")
        {
            var isFollowing = isActiveAndEnabled;
            if (isFollowing) OnDisable();
            _session = session;
            _frame = frame;
            if (isFollowing) OnEnable();
            GetComponent<PoseAppearance>().FindSession();
        }

        void OnEnable()
        {
            _followed = FollowedFrame.Of(this, _session, "tracked object", Frame, _canBeGripped, isGhost: _shows == RigPose.Held);
            if (_followed == null) return;
            _followed.Source.Movers.Add(this, Show);
        }

        void OnDisable()
        {
            if (_followed == null) return;
            _followed.Source.Movers.Remove(this);
            _followed.Leave();
            _followed = null;
        }

        void OnTransformParentChanged()
        {
            if (this.IsBelowAnotherSession(_session, _followed?.Source))
            {
                OnDisable();
                OnEnable();
            }
            else _followed?.FindWorld(this);
        }

        void Show(DisplayFrame frame)
        {
            _followed.Update(frame.Start);
            _followed.Place(transform, _shows);
        }
    }
}
