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
    /// <summary>Shows an object that does not move, such as a conveyor or a fixture: placed by its frame on /tf_static, or by hand.</summary>
    /// <remarks>
    /// A hand, a controller or a script reports the start and the end of a move. The place is then saved in a file on the device, which is also
    /// the /tf_static that the gateway publishes with <c>--stationary</c>. A source that publishes the frame has priority whenever its pose
    /// arrives, so that all headsets agree.
    /// </remarks>
    [AddComponentMenu("Nowpose/Stationary Object")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(PoseAppearance))]
    public sealed class StationaryObject : MonoBehaviour, ICellObject
    {
        [SerializeField, Tooltip("The session that receives the object's frame. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Name of the frame, the child_frame_id of /tf_static. Empty: the name of this object.")]
        string _frame = "";

        [SerializeField, Tooltip("Name of the file on the device that keeps the places of objects that were placed by hand.")]
        string _fileName = "stationary-objects.json";

        MrilSession _source;
        FollowedFrame _followed;
        RigidTransform? _saved;

        /// <summary>Name of the frame.</summary>
        public string Frame => string.IsNullOrEmpty(_frame) ? name : _frame;

        /// <summary>Whether the object is shown where it is, and otherwise why not.</summary>
        public PoseState State => _followed == null ? PoseState.Incomplete : _followed.State;

        /// <summary>Whether the object is being moved by hand.</summary>
        public bool IsMoving { get; private set; }

        /// <summary>Path of the file that keeps the places of objects that were placed by hand.</summary>
        public string SavedPath => Path.Combine(Application.persistentDataPath, _fileName);

        /// <summary>Why it is not shown where it is, in one line; null if it is.</summary>
        public string Fault => _followed == null ? "no session" : _followed.Fault;

        bool ICellObject.IsUnplaced => _followed != null && !_followed.IsKnown;

        /// <summary>Starts a move by hand: the frame follows this transform. Refused while a source or a gripper moves the object.</summary>
        public void BeginMove()
        {
            if (_followed == null) return;
            if (_followed.IsMoved)
                ConsoleLog.Warn(this, ObjectMessages.NotPlaceable(name));
            else IsMoving = true;
        }

        /// <summary>Ends a move and saves the place. Does nothing unless the object is being moved.</summary>
        public void EndMove()
        {
            if (!IsMoving) return;
            IsMoving = false;
            _followed.PlaceBy(transform);
            _saved = CellPlace.PoseIn(_followed.World, transform);
            Save();
        }

        void OnEnable()
        {
            _followed = FollowedFrame.Of(
                this, _session, "stationary object", Frame, missing: ObjectMessages.NotPlaced);
            if (_followed == null) return;
            _saved = Saved();
            _source = this.SessionOr(_session);
            _source.Shown += Show;
        }

        void OnDisable()
        {
            if (_followed == null) return;
            EndMove();
            if (_source is object) _source.Shown -= Show;
            _followed.Leave();
            _followed = null;
        }

        void Show(DisplayFrame frame)
        {
            var isNew = _followed.Update();
            if (IsMoving)
            {
                _followed.PlaceBy(transform);
                return;
            }
            if (isNew && !_followed.IsKnown && _saved is RigidTransform saved)
            {
                transform.PlaceIn(_followed.World, saved);
                _followed.PlaceBy(transform);
            }
            _followed.Place(transform, RigPose.Displayed);
        }

        RigidTransform? Saved()
        {
            var file = Load();
            for (var i = 0; i < file.Count; i++)
                if (file[i].Child == Frame) return file[i].ToPose();
            return null;
        }

        TransformsMessage Load()
        {
            if (!File.Exists(SavedPath)) return new TransformsMessage();
            try
            {
                return StationaryFrameFile.Load(SavedPath);
            }
            catch (InputException fault)
            {
                var aside = WholeFile.PutAside(SavedPath);
                ConsoleLog.Warn(this, ObjectMessages.PlacesLost(fault.Message, aside));
                return new TransformsMessage();
            }
        }

        // Other objects have their places in the same file.
        void Save()
        {
            var (before, file) = (Load(), new TransformsMessage());
            for (var i = 0; i < before.Count; i++)
                if (before[i].Child != Frame) file.Add(before[i]);
            file.Add(_saved.Value.ToTransform(default, FrameParents.World, Frame));
            try
            {
                StationaryFrameFile.Save(SavedPath, file);
            }
            catch (InputException fault)
            {
                ConsoleLog.Fail(this, fault.Message);
            }
        }
    }
}
