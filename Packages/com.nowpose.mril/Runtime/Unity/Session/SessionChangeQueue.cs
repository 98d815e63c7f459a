using System;
using System.Collections.Generic;
using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>
    /// Raises changes in order. If a listener causes another change, it is raised after all listeners have received the current change.
    /// </summary>
    sealed class SessionChangeQueue
    {
        // The initial capacity is large enough, so no frame allocates.
        readonly Queue<SessionChange> _changes = new Queue<SessionChange>(4);
        readonly Action<SessionChange> _raise;

        /// <param name="raise">Raises a change. It must not throw.</param>
        public SessionChangeQueue(Action<SessionChange> raise) => _raise = raise;

        public void Add(SessionChange change)
        {
            _changes.Enqueue(change);
            if (_changes.Count > 1) return;
            for (; _changes.Count > 0; _changes.Dequeue()) _raise(_changes.Peek());
        }
    }
}
