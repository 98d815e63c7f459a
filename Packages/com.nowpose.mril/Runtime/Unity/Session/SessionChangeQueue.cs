using System;
using System.Collections.Generic;
using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>Raises changes in their order: one that a listener causes is raised after all listeners have received the current one.</summary>
    sealed class SessionChangeQueue
    {
        // The initial capacity is sufficient, so that no frame allocates.
        readonly Queue<SessionChange> _changes = new Queue<SessionChange>(4);
        readonly Action<SessionChange> _raise;

        public SessionChangeQueue(Action<SessionChange> raise) => _raise = raise;

        public void Add(SessionChange change)
        {
            _changes.Enqueue(change);
            if (_changes.Count > 1) return;
            try
            {
                for (; _changes.Count > 0; _changes.Dequeue()) _raise(_changes.Peek());
            }
            finally
            {
                _changes.Clear();
            }
        }
    }
}
