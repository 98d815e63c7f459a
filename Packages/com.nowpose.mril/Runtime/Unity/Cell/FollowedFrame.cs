using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// Follows one frame of the cell, for an object whose pose is the pose of this frame. Switches to the new session when the session component
    /// reconnects.
    /// </summary>
    sealed class FollowedFrame : IShownPart
    {
        readonly MrilSession _source;
        readonly bool _isGhost, _canBeGripped;
        readonly string _missing;
        readonly string _invalid;
        readonly bool _canWaitForClock;
        readonly FrameFault _fault = new FrameFault();
        SettledPose _settled = new SettledPose();
        // Reason and time of the last frame in which the pose was held; the settled state may still be held when the pose is current again.
        (string Fault, ControlTime? Since) _held;
        DropReason _refused;
        CompensationSession _session;
        CellFrame _frame;

        FollowedFrame(MrilSession source, Transform world, string name, bool canBeGripped, bool isGhost, string missing)
        {
            _source = source;
            Name = name;
            _isGhost = isGhost;
            _canBeGripped = canBeGripped;
            _invalid = IsValid(name) ? null : ObjectMessages.InvalidFrame(name);
            _missing = _invalid ?? missing ?? FrameMessages.NoPose;
            _canWaitForClock = missing == null;
            World = world;
            Title = "object " + InputException.OneLine(name, ProtocolLimits.NameLength);
            if (!isGhost) source.Parts.Add(this, canBeGripped ? name : null);
        }

        /// <summary>The component that has the session.</summary>
        public MrilSession Source => _source;

        /// <summary>Name of the frame since the component was enabled.</summary>
        public string Name { get; }

        /// <summary>Whether the name is a valid name of a frame. An invalid frame is never placed.</summary>
        public bool IsNameValid => _invalid == null;

        public string Title { get; }

        /// <summary>The transform that is the frame <c>world</c>; equal to null if it was destroyed. The object then stays where it is.</summary>
        public Transform World { get; private set; }

        /// <summary>Name of the frame in which the displayed pose is given; null while no pose is known.</summary>
        public string Parent => _frame?.Parent;

        /// <summary>Where the displayed pose comes from: a topic, a gripper or the user; null while no pose is known.</summary>
        public string Origin
        {
            get
            {
                if (_frame == null) return null;
                if (_frame.Reach != null) return ObjectMessages.FromGripper;
                if (_frame.IsPlacedByHand) return ObjectMessages.PlacedByHand;
                return _frame.HasStationarySource ? RosTopics.TfStatic : RosTopics.Tf;
            }
        }

        /// <summary>Whether a pose of the frame is known.</summary>
        public bool IsKnown => _frame != null;

        /// <summary>Whether the frame can move: its source publishes it as moving, or a gripper holds it.</summary>
        public bool IsMoved => _frame != null && !_frame.IsStationary;

        /// <summary>Whether the frame's pose is known and is the same at any time.</summary>
        public bool IsFixed => _frame != null && _frame.IsFixed;

        public PoseState State =>
            _session == null || HasEnded ? PoseState.Incomplete : CellPlace.StateIn(World, _session.Frames.StateOf(_frame));

        /// <summary>State that the object's look shows, see <see cref="SettledPose"/>.</summary>
        public PoseState SettledState => _settled.Over(State);

        // The states in a session that has ended are those of its last frame.
        bool HasEnded => _source.Session != _session;

        /// <summary>Reason why the pose is not current, in one line; null if it is current.</summary>
        public string Fault => FaultIn(State);

        string IShownPart.Fault => (IsHeldLooking ? _held.Fault : null) ?? FaultIn(SettledState);

        ControlTime? IShownPart.FaultSince => (IsHeldLooking ? _held.Since : null) ?? FaultSince;

        bool IsHeldLooking => SettledState == PoseState.Held;

        string FaultIn(PoseState state)
        {
            if (_session != null && HasEnded) return StatusMessages.NoSession;
            switch (state)
            {
                case PoseState.Current: return null;
                case PoseState.Incomplete: return _frame == null ? _missing : ReasonOf(_frame);
                case PoseState.Held: return World == null ? BaseMessages.Destroyed : ReasonOf(_frame) ?? StatusMessages.ReasonOf(state);
                default: return PoseMessages.Of(state);
            }
        }

        // Null if the frame is current again.
        string ReasonOf(CellFrame held) => _fault.Of(held, _session.Frames.Tree);

        public bool IsFaultCommon
        {
            get
            {
                if (_session == null || HasEnded || _invalid != null) return false;
                // Poses of moving frames wait for the clock, so a frame without a pose may already have one.
                if (_frame == null) return _canWaitForClock && _session.Frames.IsWaitingForClock;
                return SettledState == PoseState.Unsynchronised || SettledState == PoseState.OutsideRange;
            }
        }

        public ControlTime? FaultSince => HasEnded ? null : _session?.Frames.HeldSince(_frame);

        /// <summary>Starts to follow a frame in the session of a component.</summary>
        /// <param name="kind">Kind of the component, for the text of the warning that is logged if it has no session.</param>
        /// <param name="canBeGripped">Whether a gripper can grip the object by reach. Not used for a ghost.</param>
        /// <param name="isGhost">Whether the object is a second view of a frame that another object shows. It is then not listed again.</param>
        /// <param name="missing">Value of <see cref="Fault"/> while no pose of a frame that does not move is known; null for other frames.</param>
        /// <returns>Null if the component has no session.</returns>
        public static FollowedFrame Of(
            Component component, MrilSession assigned, string kind, string name, bool canBeGripped, bool isGhost = false, string missing = null)
        {
            var source = component.RequiredSession(assigned, kind);
            if (source == null) return null;
            var followed = new FollowedFrame(source, CellPlace.WorldOf(component, source), name, canBeGripped, isGhost, missing);
            if (followed._invalid != null) ConsoleLog.Fail(component, ComponentMessages.Of(kind, component.name, followed._invalid));
            return followed;
        }

        /// <summary>Updates <see cref="World"/> after the component or one of its parents has got a new parent.</summary>
        public void FindWorld(Component component)
        {
            if (_source != null) World = CellPlace.WorldOf(component, _source);
        }

        /// <summary>Stops following the frame.</summary>
        public void Leave()
        {
            if (!_isGhost) _source.Parts.Remove(this, _canBeGripped ? Name : null);
            if (_session != null && IsNameValid) _session.Frames.Leave(Name);
            _session = null;
            _frame = null;
        }

        /// <summary>Updates the session and the frame that this object follows. Call it once per frame, before the other methods.</summary>
        /// <param name="at">Start of the frame.</param>
        /// <returns>True if the session has changed since the last call.</returns>
        public bool Update(HeadsetTime at)
        {
            var isNew = _source.Session != _session;
            if (isNew)
            {
                _session = _source.Session;
                _frame = null;
                _settled = new SettledPose();
                if (IsNameValid) _session.Frames.Need(Name);
            }
            _frame ??= _session.Frames.Find(Name);
            var state = State;
            _settled.Add(at, state);
            KeepHeld(state);
            return isNew;
        }

        // The time is that of the first frame with this reason, so that it does not change with each pose that arrives.
        void KeepHeld(PoseState state)
        {
            // A ghost is not listed.
            if (_isGhost) return;
            if (_settled.Over(state) != PoseState.Held) _held = default;
            if (state != PoseState.Held) return;
            var fault = FaultIn(state);
            if (fault != _held.Fault || !_held.Since.HasValue) _held = (fault, FaultSince);
        }

        static bool IsValid(string name) => name.Length > 0 && name.Length <= ProtocolLimits.NameLength && name != FrameParents.World;

        /// <summary>Places the frame at the pose of a transform, until a source publishes the frame. Does nothing without a session.</summary>
        public void PlaceBy(Transform placed)
        {
            if (_session == null || !IsNameValid || World == null) return;
            var reason = _session.Frames.Place(Name, CellPlace.PoseIn(World, placed));
            if (reason == DropReason.None) _frame = _session.Frames.Find(Name);
            else if (reason != _refused) ConsoleLog.Fail(placed, ObjectMessages.NotAccepted(Title, reason));
            _refused = reason;
        }

        /// <summary>Distance between the displayed pose and the newest pose in metres; null while the pose is unknown.</summary>
        public float? GapMetres
        {
            get
            {
                if (_frame == null || State == PoseState.Incomplete) return null;
                return Vector3.Distance(UnityFrame.ToUnity(_frame.World).Position(), UnityFrame.ToUnity(Held).Position());
            }
        }

        RigidTransform Held => _session.Frames.Tree.HeldOf(_session.Frames.Tree.IndexOf(Name));

        /// <summary>Moves a transform to the frame's pose. Does nothing while the pose is unknown.</summary>
        /// <param name="shows">Selects the pose at the display time or the newest received pose.</param>
        public void Place(Transform moved, RigPose shows)
        {
            if (_frame == null || State == PoseState.Incomplete || World == null) return;
            moved.PlaceIn(World, shows == RigPose.Displayed ? _frame.World : Held);
        }
    }
}
