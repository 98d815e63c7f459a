using System;
using System.IO;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>
    /// Shows an object that does not move, such as a conveyor or a fixture. It is shown at its frame on /tf_static, or where the user has placed it
    /// by hand.
    /// </summary>
    /// <remarks>
    /// The component that moves the object (by hand, by controller or by script) calls <see cref="BeginMove"/> and <see cref="EndMove"/>.
    /// The place is then saved in a file on the device. The gateway can publish the same file on /tf_static with its option
    /// <c>--stationary</c>. A published pose always has priority over a saved place, so all headsets show the object in the same place.
    /// </remarks>
    [AddComponentMenu("Nowpose/Stationary Object")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(PoseAppearance))]
    public sealed class StationaryObject : MonoBehaviour, ICellObject, IFollowsSession
    {
        const string DefaultFile = "stationary-objects.json";

        [SerializeField, Tooltip("The session that receives the object's frame. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the frame, the child_frame_id of /tf_static. Empty: the name of this object.")]
        string _frame = "";

        [SerializeField, Tooltip("Name of the file on the device that stores the poses of objects that were placed by hand. The name of the Base Anchor's "
            + "cell is added. Empty: stationary-objects.json.")]
        string _fileName = DefaultFile;

        [SerializeField, Tooltip("Whether a Grip by Reach can grip the object. It takes effect when this component is enabled.")]
        bool _canBeGripped = false;

        FollowedFrame _followed;
        RigidTransform? _saved;
        [NonSerialized] string _readPath;

        /// <summary>Name of the frame.</summary>
        public string Frame => _followed != null ? _followed.Name : string.IsNullOrEmpty(_frame) ? name : _frame;

        /// <summary>State of the object's pose. If the object is not shown at its real place, the state gives the reason.</summary>
        public PoseState State => _followed == null ? PoseState.Incomplete : _followed.State;

        /// <summary>Whether a move by hand is in progress.</summary>
        public bool IsMoving { get; private set; }

        /// <summary>
        /// Path of the file with the places of all objects that were placed by hand. The places are relative to the base, so each cell of a Base Anchor has
        /// its own file: its name is added to the file name.
        /// </summary>
        public string SavedPath
        {
            get
            {
                var name = string.IsNullOrEmpty(_fileName) ? DefaultFile : _fileName;
                // During a move, the parents may be inactive or others.
                var world = _followed?.World;
                var anchor = world != null ? world.GetComponent<BaseAnchor>() : CellPlace.AnchorOf(this, this.SessionOr(_session));
                if (anchor != null && !string.IsNullOrEmpty(anchor.Cell))
                    name = Path.ChangeExtension(name, null) + "-" + Uri.EscapeDataString(anchor.Cell).Replace("%20", " ") + Path.GetExtension(name);
                return Path.Combine(Application.persistentDataPath, name);
            }
        }

        /// <summary>Reason why the object's pose is not current, in one line; null if it is current.</summary>
        public string Fault =>
            _followed != null ? _followed.Fault : isActiveAndEnabled ? StatusMessages.NoSession : ObjectMessages.Disabled("stationary object", name);

        /// <summary>The frame that the object follows; null while it follows none.</summary>
        internal FollowedFrame Followed => _followed;

        MrilSession IFollowsSession.AssignedSession => _session;

        PoseState ICellObject.SettledState => _followed == null ? PoseState.Incomplete : _followed.SettledState;

        Transform ICellObject.World => _followed?.World;

        bool ICellObject.IsUnplaced => _followed != null && !_followed.IsKnown;

        bool ICellObject.IsFixed => _followed != null && _followed.IsFixed;

        /// <summary>
        /// Sets the fields Session and Frame, and follows the frame from now on; ends a move by hand. A script can call this method at any time, for
        /// example after it has created the object.
        /// </summary>
        /// <param name="session">The session that receives the object's frame; null to use the session on this object or a parent.</param>
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

        /// <summary>
        /// Starts a move by hand, in which the frame follows this transform. Does nothing while a source or a gripper moves the object.
        /// </summary>
        public void BeginMove()
        {
            if (_followed == null) return;
            if (_followed.IsMoved)
                ConsoleLog.Warn(this, ObjectMessages.NotPlaceable(name));
            else IsMoving = true;
        }

        /// <summary>Ends a move and saves the place. Does nothing if no move is in progress.</summary>
        public void EndMove()
        {
            if (!IsMoving) return;
            IsMoving = false;
            if (!_followed.IsNameValid || _followed.World == null) return;
            _followed.PlaceBy(transform);
            _saved = CellPlace.PoseIn(_followed.World, transform);
            Save();
        }

        void OnEnable()
        {
            _followed = FollowedFrame.Of(this, _session, "stationary object", Frame, _canBeGripped, missing: ObjectMessages.NotPlaced);
            if (_followed == null) return;
            if (_followed.Source.Movers.HasAny(mover => mover is StationaryObject other && HasPlaceOf(other))) ConsoleLog.Warn(this, ObjectMessages.SameFrame(name, Frame));
            _readPath = null;
            _followed.Source.Movers.Add(this, Show);
        }

        /// <summary>Returns whether this and another object have the same saved place, so that each replaces that of the other.</summary>
        internal bool HasPlaceOf(StationaryObject other) => Frame == other.Frame && SavedPath == other.SavedPath;

        void OnDisable()
        {
            if (_followed == null) return;
            EndMove();
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
            var isNew = _followed.Update(frame.Start);
            if (IsMoving)
            {
                _followed.PlaceBy(transform);
                return;
            }
            // A new session may be that of another cell.
            if (isNew) ReadSaved();
            if (isNew && !_followed.IsKnown && _followed.World != null && _saved is RigidTransform saved)
            {
                transform.PlaceIn(_followed.World, saved);
                _followed.PlaceBy(transform);
            }
            _followed.Place(transform, RigPose.Displayed);
        }

        void ReadSaved()
        {
            var path = SavedPath;
            if (path == _readPath) return;
            _saved = null;
            var file = Load(path);
            _readPath = file != null ? path : null;
            for (var i = 0; i < file?.Count; i++)
                if (file[i].Child == Frame) _saved = file[i].ToPose();
        }

        // Returns null if the file could not be read. It may be valid, so it must not be overwritten.
        TransformsMessage Load(string path)
        {
            if (!File.Exists(path)) return new TransformsMessage();
            try
            {
                return StationaryFrameFile.Load(path);
            }
            catch (InputException fault) when (WholeFile.IsUnread(fault))
            {
                ConsoleLog.Warn(this, fault.Message);
                return null;
            }
            catch (InputException fault)
            {
                var aside = WholeFile.PutAside(path);
                ConsoleLog.Warn(this, ObjectMessages.PlacesLost(fault.Message, aside));
                return new TransformsMessage();
            }
        }

        // Keeps the places of the other objects, which are in the same file.
        void Save()
        {
            var path = SavedPath;
            var (before, file) = (Load(path), new TransformsMessage());
            if (before == null)
            {
                ConsoleLog.Fail(this, ObjectMessages.PlaceNotSaved(name, path));
                return;
            }
            for (var i = 0; i < before.Count; i++)
                if (before[i].Child != Frame) file.Add(before[i]);
            file.Add(_saved.Value.ToTransform(default, FrameParents.World, Frame));
            try
            {
                StationaryFrameFile.Save(path, file);
            }
            catch (InputException fault)
            {
                ConsoleLog.Fail(this, fault.Message);
            }
        }
    }
}
