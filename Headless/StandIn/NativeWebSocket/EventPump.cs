using System;
using System.Collections.Concurrent;
using System.Threading;

namespace NativeWebSocket
{
    /// <summary>Raises events where the package raises them: on the context of whoever made the socket, else when it is asked to.</summary>
    sealed class EventPump
    {
        readonly SynchronizationContext _context = SynchronizationContext.Current;
        readonly ConcurrentQueue<Action> _waiting = new ConcurrentQueue<Action>();

        public void Raise(Action raise)
        {
            if (_context == null) _waiting.Enqueue(raise);
            else _context.Post(_ => raise(), null);
        }

        public void Dispatch()
        {
            while (_waiting.TryDequeue(out var raise)) raise();
        }
    }
}
