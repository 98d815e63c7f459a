using System;
using System.Collections.Generic;
using Nowpose.Session;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// The components that move objects of the scene in each frame. An object moves before the objects below it in the hierarchy, which it carries;
    /// otherwise these would be displaced by its motion since the last frame. Does not allocate in a frame, unless the hierarchy has changed.
    /// </summary>
    sealed class Movers
    {
        readonly List<Mover> _movers = new List<Mover>();
        Mover[] _order = Array.Empty<Mover>();
        bool _isChanged, _isStopped;

        /// <param name="component">The component whose object is moved.</param>
        /// <param name="move">Moves the object to its place in a frame.</param>
        public void Add(Component component, Action<DisplayFrame> move)
        {
            _movers.Add(new Mover(component, move));
            _isChanged = true;
        }

        public void Remove(Component component)
        {
            foreach (var mover in _movers) mover.IsRemoved |= mover.Component == component;
            _movers.RemoveAll(mover => mover.IsRemoved);
            _isChanged = true;
        }

        /// <summary>Returns whether a component that moves its object meets a condition.</summary>
        public bool HasAny(Predicate<Component> condition) => _movers.Exists(mover => condition(mover.Component));

        public void Move(DisplayFrame frame)
        {
            _isStopped = false;
            if (_isChanged || !IsInOrder()) Arrange();
            // A component that a listener has added in the meantime moves from the next frame on.
            foreach (var mover in _order)
            {
                if (_isStopped) return;
                if (!mover.IsRemoved) mover.Move(frame);
            }
        }

        /// <summary>Ends the present call of <see cref="Move"/>, because the session of its frame has ended.</summary>
        public void Stop() => _isStopped = true;

        bool IsInOrder()
        {
            var above = 0;
            foreach (var mover in _order)
            {
                var depth = mover.Depth;
                if (depth < above) return false;
                above = depth;
            }
            return true;
        }

        void Arrange()
        {
            _isChanged = false;
            var depths = new int[_movers.Count];
            _order = _movers.ToArray();
            for (var i = 0; i < _order.Length; i++) depths[i] = _order[i].Depth * _order.Length + i;
            Array.Sort(depths, _order);
        }

        sealed class Mover
        {
            readonly Action<DisplayFrame> _move;

            public Mover(Component component, Action<DisplayFrame> move) => (Component, _move) = (component, move);

            public Component Component { get; }

            public bool IsRemoved { get; set; }

            /// <summary>Number of objects above the component's object.</summary>
            public int Depth
            {
                get
                {
                    var depth = 0;
                    for (var above = Component.transform.parent; above != null; above = above.parent) depth++;
                    return depth;
                }
            }

            // An error of one component must not stop the others, which would then look current at an old pose.
            public void Move(DisplayFrame frame)
            {
                try
                {
                    _move(frame);
                }
                catch (Exception fault)
                {
                    Debug.LogException(fault, Component);
                }
            }
        }
    }
}
