using Nowpose.Frames;
using Nowpose.Session;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>Follows one frame of the cell over all sessions of a session component, for an object that shows it.</summary>
    sealed class FollowedFrame : IShownPart
    {
        readonly MrilSession _source;
        readonly string _name;
        readonly bool _isGhost;
        CompensationSession _session;
        CellFrame _frame;

        FollowedFrame(MrilSession source, Transform world, string name, bool isGhost)
        {
            _source = source;
            _name = name;
            _isGhost = isGhost;
            World = world;
            Title = "object " + name;
            if (!isGhost) source.Parts.Add(this, name);
        }

        public string Title { get; }

        /// <summary>The transform that is the frame <c>world</c>.</summary>
        public Transform World { get; }

        /// <summary>Name of the frame in which the displayed pose is given; null while no pose is known.</summary>
        public string Parent => _frame?.Parent;

        public PoseState State => _session == null ? PoseState.Incomplete : _session.Frames.StateOf(_frame);

        public string Fault
        {
            get
            {
                switch (State)
                {
                    case PoseState.Current: return null;
                    case PoseState.Incomplete: return _frame == null ? "no pose received" : "its parent is unknown";
                    case PoseState.Held: return "its poses have stopped";
                    default: return PoseWords.Of(State);
                }
            }
        }

        /// <param name="what">Kind and name of the component, for the warning if it has no session.</param>
        /// <param name="isGhost">Whether the object is shown a second time, so that it is not listed again.</param>
        /// <returns>Null without a session.</returns>
        public static FollowedFrame Of(Component component, MrilSession assigned, string what, string name, bool isGhost)
        {
            var source = component.SessionOr(assigned);
            if (source != null) return new FollowedFrame(source, CellPlace.WorldOf(component, source), name, isGhost);
            ConsoleLog.Warn(component, what + " has no session on its object or a parent; assign one");
            return null;
        }

        /// <summary>Ends following.</summary>
        public void Leave()
        {
            if (!_isGhost) _source.Parts.Remove(this, _name);
            _session = null;
            _frame = null;
        }

        /// <summary>Moves a transform to the frame's pose; it stays where it is while that is unknown. Call it once for each frame.</summary>
        /// <param name="shows">Whether the pose at the display time or the newest received one is shown.</param>
        public void Place(Transform moved, RigPose shows)
        {
            var session = _source.Session;
            if (session != _session)
            {
                _session = session;
                _frame = null;
                session.Frames.Need(_name);
            }
            _frame ??= session.Frames.Find(_name);
            if (_frame == null || State == PoseState.Incomplete) return;
            var tree = session.Frames.Tree;
            moved.PlaceIn(World, shows == RigPose.Displayed ? _frame.World : tree.HeldOf(tree.IndexOf(_name)));
        }
    }
}
