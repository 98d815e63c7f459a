using System;
using System.Collections.Generic;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>
    /// Queue of messages for the next frame, with their arrival times. When it is full, the oldest message leaves it, but the newest of these messages with
    /// each list of names is kept. Thread-safe.
    /// </summary>
    /// <remarks>
    /// A source may send a stationary frame only once, or the position of a gripper only when it changes. The messages of another source must not remove it,
    /// for example while no frame is computed because the program loads a scene.
    /// </remarks>
    sealed class Arrivals<T>
        where T : class
    {
        /// <summary>Maximum number of messages that are kept in addition to the queue: one for each frame of a cell.</summary>
        public const int MaxKept = ProtocolLimits.Frames;

        readonly Queue<Arrival<T>> _queue;
        readonly List<Arrival<T>> _kept = new List<Arrival<T>>();
        readonly int _capacity;
        readonly Func<T, T, bool> _haveSameNames;

        /// <param name="capacity">Queue capacity in messages.</param>
        /// <param name="haveSameNames">Returns whether the newer of two messages replaces the older one. Null: no message is kept.</param>
        public Arrivals(int capacity, Func<T, T, bool> haveSameNames = null)
        {
            // For the message that makes the oldest one leave, too.
            _queue = new Queue<Arrival<T>>(capacity + 1);
            _capacity = capacity;
            _haveSameNames = haveSameNames;
        }

        /// <param name="dropped">The message that was dropped because the queue was full.</param>
        /// <returns>Whether a message was dropped.</returns>
        public bool Add(T message, HeadsetTime at, out Arrival<T> dropped)
        {
            lock (_queue)
            {
                _queue.Enqueue(new Arrival<T>(message, at));
                dropped = default;
                if (_queue.Count <= _capacity) return false;
                dropped = _queue.Dequeue();
                return _haveSameNames == null || Replace(ref dropped);
            }
        }

        /// <summary>Moves all messages into a list, in the order of their arrival. Replaces its elements.</summary>
        public void TakeAll(List<Arrival<T>> into)
        {
            into.Clear();
            lock (_queue)
            {
                into.AddRange(_kept);
                _kept.Clear();
                while (_queue.Count > 0) into.Add(_queue.Dequeue());
            }
        }

        // Keeps the message that has left the queue. Returns whether another one is dropped for it.
        bool Replace(ref Arrival<T> dropped)
        {
            _kept.Add(dropped);
            var former = 0;
            while (!_haveSameNames(_kept[former].Message, dropped.Message)) former++;
            if (former == _kept.Count - 1)
            {
                if (_kept.Count <= MaxKept) return false;
                former = 0;
            }
            dropped = _kept[former];
            _kept.RemoveAt(former);
            return true;
        }
    }
}
