using System.Collections.Concurrent;

namespace NativeWebSocket
{
    /// <summary>
    /// Raises events as the package does: posts them to the synchronisation context in which the socket was created. Without a context, events wait
    /// for <see cref="Dispatch"/>.
    /// </summary>
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
