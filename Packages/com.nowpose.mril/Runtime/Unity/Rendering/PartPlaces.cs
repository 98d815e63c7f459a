using System.Collections.Generic;
using Nowpose.Session;
using UnityEngine;

namespace Nowpose.Unity.Rendering
{
    /// <summary>The parts of an appearance that one object, rig, gripper or anchor moves, with the state of their pose that was last drawn.</summary>
    sealed class PartPlace
    {
        public PartPlace(Transform mover) => Mover = mover;

        public Transform Mover { get; }

        public PlacedState State { get; private set; }

        public OutsideRangeResponse OutsideRange { get; private set; }

        /// <summary>The look that the state of the anchor requires.</summary>
        public BaseLook Base { get; private set; }

        /// <summary>Reads the state again.</summary>
        /// <returns>Whether it has changed.</returns>
        public bool Update(DisplayFrame frame, MrilSession source)
        {
            var (before, known) = (State, Base);
            State = PlacedState.Of(Mover, frame, source);
            OutsideRange = frame.OutsideRange;
            Base = BaseLook.Of(State.Anchor);
            return State.Pose != before.Pose || State.IsUnplaced != before.IsUnplaced || !Base.IsSameAs(known);
        }
    }

    /// <summary>
    /// The parts of an appearance, grouped by the component that moves them. One appearance has several groups if another rig or an object is below it
    /// that has no appearance of its own, or whose appearance was destroyed or disabled.
    /// </summary>
    sealed class PartPlaces
    {
        readonly List<PartPlace> _places = new List<PartPlace>();

        public int Count => _places.Count;

        /// <summary>Whether an object, rig, gripper or anchor that moves parts was destroyed, so that its group no longer has a state. Allocates nothing.</summary>
        public bool HasLostMover
        {
            get
            {
                foreach (var place in _places)
                    if (place.Mover == null) return true;
                return false;
            }
        }

        public PartPlace this[int index] => _places[index];

        public void Clear() => _places.Clear();

        /// <summary>Returns the group of a part. A new group is <see cref="PoseState.Incomplete"/> before the first frame.</summary>
        /// <param name="root">The object of the appearance, at or above the part.</param>
        /// <param name="frame">The last frame; null before the first one.</param>
        public PartPlace Add(Transform part, Transform root, DisplayFrame frame, MrilSession source)
        {
            var mover = PlacedState.MoverOf(part, root);
            foreach (var known in _places)
                if (known.Mover == mover) return known;
            var added = new PartPlace(mover);
            if (frame != null) added.Update(frame, source);
            _places.Add(added);
            return added;
        }

        /// <summary>Reads the states of all groups again. Allocates nothing.</summary>
        /// <returns>Whether any state has changed.</returns>
        public bool Update(DisplayFrame frame, MrilSession source)
        {
            var hasChanged = false;
            foreach (var place in _places) hasChanged |= place.Update(frame, source);
            return hasChanged;
        }
    }
}
